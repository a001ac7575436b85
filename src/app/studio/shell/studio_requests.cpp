// What panels, keys and scripts ask of the program.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/actions.h"
#include "app/studio/app/camera_tool.h"
#include "app/studio/document/file_listing.h"
#include "app/studio/shell/studio.h"
#include "app/studio/shell/window/png.h"
#include "core/base/files.h"

namespace taxel::studio {

namespace {

/// "screenshot-1.png", or the first number that is free.
std::string free_name(std::string_view begin, std::string_view end) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}{}{}", begin, number, end);
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) return name;
  }
}

}  // namespace

void Studio::carry_out_requests() {
  std::vector<ui::Request> requests;
  requests.swap(ui_.requests);
  for (const ui::Request& request : requests) carry_out(request);
}

void Studio::carry_out(const ui::Request& request) {
  if (hold_if_unsaved(request) || carry_out_edit(request) || carry_out_save(request) || carry_out_generate(request) ||
      carry_out_real(request))
    return;
  if (const auto* r = std::get_if<ui::OpenFile>(&request)) {
    open_file(*r);
  } else if (std::holds_alternative<ui::OpenFingertipSweep>(request)) {
    session_.open("");
  } else if (std::holds_alternative<ui::CloseDocument>(request)) {
    session_.close();
    ui_.selection = {};
  } else if (const auto* list = std::get_if<ui::ListFolder>(&request)) {
    list_folder(ui_.dialog, list->path);
  } else if (std::holds_alternative<ui::CancelLoading>(request)) {
    session_.cancel_loading();
  } else if (std::holds_alternative<ui::PolishSamples>(request)) {
    session_.polish();
  } else if (const auto* run = std::get_if<ui::RunScenario>(&request)) {
    session_.run_scenario(run->scenario);
  } else if (std::holds_alternative<ui::PlayOrPause>(request)) {
    if (!session_.shows_scene() && !run_or_say_why_not()) return;
    session_.hand_over();
    session_.set_playing(!session_.moves());
  } else if (std::holds_alternative<ui::StepOnce>(request)) {
    session_.step_by(1);
  } else if (carry_out_in_time(request) || carry_out_in_scene(request)) {
    return;
  } else if (std::holds_alternative<ui::ResetSimulation>(request)) {
    session_.reset();
  } else if (const auto* speed = std::get_if<ui::SetSpeed>(&request)) {
    session_.set_speed(speed->factor);
  } else if (const auto* mode = std::get_if<ui::SetMode>(&request)) {
    set_mode(mode->mode);
  } else if (std::holds_alternative<ui::ReloadFile>(request)) {
    session_.reload();
  } else if (std::holds_alternative<ui::TakeScreenshot>(request)) {
    screenshot_wanted_ = true;
  } else if (std::holds_alternative<ui::Quit>(request)) {
    quit_ = true;
  }
}

bool Studio::carry_out_in_time(const ui::Request& request) {
  if (std::holds_alternative<ui::StepBack>(request)) {
    session_.step_by(-1);
  } else if (const auto* to = std::get_if<ui::ScrubTo>(&request)) {
    session_.scrub(to->step);
  } else if (const auto* replay = std::get_if<ui::ReplayHistory>(&request)) {
    session_.replay(replay->direction);
  } else if (const auto* loop = std::get_if<ui::SetLoop>(&request)) {
    session_.set_loop(loop->range);
  } else if (const auto* breakpoints = std::get_if<ui::SetBreakpoints>(&request)) {
    session_.set_breakpoints(breakpoints->breakpoints);
  } else if (const auto* limits = std::get_if<ui::SetHistoryLimits>(&request)) {
    session_.set_history_limits(limits->limits);
  } else if (const auto* record = std::get_if<ui::SetRecording>(&request)) {
    session_.record(record->on, free_name("recording-", ""));
  } else if (std::holds_alternative<ui::CancelVideo>(request)) {
    video_.reset();
  } else {
    return false;
  }
  return true;
}

bool Studio::carry_out_in_scene(const ui::Request& request) {
  if (const auto* command = std::get_if<ui::SendCommand>(&request)) {
    session_.send(command->command);
  } else if (const auto* attach = std::get_if<ui::AttachLayout>(&request)) {
    attach->path.empty() ? ask_for_file(ui::FileTask::attach_layout, "") : session_.attach(attach->geoms, attach->path);
  } else if (const auto* detach = std::get_if<ui::DetachLayout>(&request)) {
    session_.detach(detach->geom);
  } else {
    return false;
  }
  return true;
}

bool Studio::run_or_say_why_not() {
  if (session_.run_scenario(session_.scenario())) return true;
  if (input_.model && input_.model->taxel_count() == 0)
    ui::add_message(ui_, Severity::warning,
                    "Nothing to simulate: the layout has no taxels. Ctrl+click on the mesh places a taxel, Ctrl+G "
                    "generates a pattern.",
                    ImGui::GetTime());
  return false;
}

void Studio::set_mode(ui::Mode mode) {
  const bool runs = session_.shows_scene() || session_.frame() != nullptr;
  if (mode == ui::Mode::simulate && !session_.shows_scene() && !run_or_say_why_not() && !runs) return;
  if (mode == ui::Mode::simulate) session_.hand_over();
  checks_view_ = checks_view_ || ui_.mode != mode;
  ui_.mode = mode;
}

void Studio::save_screenshot(const std::string& file) {
  painter_->forget();
  fill_window();  // what was shown last may be gone
  write_png(file, window_->read());
}

void Studio::save_numbered_screenshot() {
  try {
    const std::string name = free_name("screenshot-", ".png");
    save_screenshot(name);
    ui::add_message(ui_, Severity::note, "Saved " + std::filesystem::absolute(name).string(), ImGui::GetTime());
  } catch (const Error& error) {
    ui::add_message(ui_, Severity::error, error.what(), ImGui::GetTime());
  }
}

void Studio::save_state(const std::string& file) {
  pace_.scene_draws = ui_.view.draws - draws_at_dump_;
  draws_at_dump_ = ui_.view.draws;
  write_file_atomically(file, state_to_json(ui_, input_, pace_));
  pace_ = {};
}

void Studio::finish_outputs() {
  if (!options_.screenshot.empty()) save_screenshot(options_.screenshot);
  if (!options_.dump_state.empty()) save_state(options_.dump_state);
  if (!options_.cut_out.empty()) {
    write_png(options_.cut_out, cut_out(options_.cut_out_width, options_.cut_out_height));
  }
}

ImVec2 Studio::locate(const Target& target) const {
  if (const auto* pixel = std::get_if<PixelTarget>(&target)) {
    return {static_cast<float>(pixel->x), static_cast<float>(pixel->y)};
  }
  if (const auto* widget = std::get_if<WidgetTarget>(&target)) {
    const ui::WidgetRegistry::Entry* entry = ui_.widgets.find(widget->label);
    if (entry == nullptr) throw Error(fmt::format("no widget \"{}\" is visible", widget->label));
    return {entry->rect.center_x(), entry->rect.center_y()};
  }
  dvec3 p_W{0};
  if (const auto* world = std::get_if<WorldTarget>(&target)) p_W = world->p_W;
  if (const auto* wanted = std::get_if<TaxelTarget>(&target)) {
    const Layout* layout = input_.shown_layout(ui_);
    if (layout == nullptr) throw Error("no layout is open");
    const auto& taxels = layout->taxels;
    const auto taxel = std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == wanted->id; });
    if (taxel == taxels.end()) throw Error(fmt::format("there is no taxel {}", wanted->id));
    p_W = ui::shown_pose(ui_, input_) * taxel->center;
  }
  const dvec3 pixel = ui_.camera().project(p_W, ui_.view.width, ui_.view.height);
  const bool inside =
      pixel.z > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < ui_.view.width && pixel.y < ui_.view.height;
  if (!inside) throw Error("the point is outside of the view");
  return {ui_.view.rect.x0 + static_cast<float>(pixel.x), ui_.view.rect.y0 + static_cast<float>(pixel.y)};
}

ScriptStage Studio::script_stage() {
  ScriptStage stage;
  stage.locate = [this](const Target& target) { return locate(target); };
  stage.idle = [this] {
    const bool generated = !session_.patterns().busy() && !fresh_preview();
    return session_.idle() && generated && !comparison_.busy() && input_taken() && ui_.requests.empty() && !video_;
  };
  stage.running_time = [this]() -> std::optional<double> {
    const bool runs = session_.frame() && session_.playing() && !session_.frame()->finished;
    return runs ? std::optional<double>(session_.frame()->time) : std::nullopt;
  };
  stage.save_screenshot = [this](const std::string& file) { save_screenshot(file); };
  stage.save_state = [this](const std::string& file) { save_state(file); };
  stage.state = [this] { return state_to_json(ui_, input_, pace_); };
  stage.quit = [this] { quit_ = true; };
  return stage;
}

}  // namespace taxel::studio
