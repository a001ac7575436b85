// Commands to the program, carried out; files that the program writes at its end; and the program as scripts see it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/error_bars_state.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/free_name.h"
#include "app/studio/shell/interface/carry_out.h"
#include "app/studio/shell/studio.h"
#include "app/studio/shell/window/png.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

void Studio::carry_out_commands() {
  std::vector<ui::Command> commands;
  commands.swap(app_.ui->commands);
  for (const ui::Command& posted : commands) {
    if (hold_if_unsaved(posted)) continue;
    std::visit(
        [&](const auto& command) {
          if constexpr (ui::InterfaceCommand<decltype(command)>) {
            std::vector<ui::Command> later;
            later.swap(app_.ui->commands);
            ui::CarryOut{app_}(command);
            carry_out_commands();  // those that the command has posted
            later.insert(later.end(), app_.ui->commands.begin(), app_.ui->commands.end());
            app_.ui->commands = std::move(later);
          } else {
            carry_out(command);
          }
        },
        posted);
  }
}

void Studio::carry_out(const ui::CloseDocument&) {
  session_.close();
  app_.viewer->selection = {};
}

void Studio::carry_out(const ui::ListFolder& command) {
  list_folder(app_.get<ui::FileDialog>(), command.path);
}

/// In LAYOUT nothing is simulated: the run goes on in SIMULATE.
void Studio::carry_out(const ui::PlayOrPause&) {
  if (app_.viewer->mode == ui::Mode::layout) {
    carry_out(ui::SetMode{ui::Mode::simulate});
    if (app_.viewer->mode == ui::Mode::simulate && session_.shows_scene()) session_.set_playing(true);
    return;
  }
  if (!session_.shows_scene() && !run_or_say_why_not()) return;
  session_.hand_over();
  session_.set_playing(!session_.moves());
}

void Studio::carry_out(const ui::SetRecording& command) {
  session_.record(command.on, free_name("recording-", ""), app_.get<ui::ErrorBarsState>().on);
}

void Studio::carry_out(const ui::AttachLayout& command) {
  command.path.empty() ? ask_for_file(ui::FileTask::attach_layout, "") : session_.attach(command.geoms, command.path);
}

bool Studio::run_or_say_why_not() {
  if (session_.run_scenario(session_.scenario())) return true;
  if (app_.shown->document.model && app_.shown->document.model->taxel_count() == 0)
    ui::add_message(app_.get<ui::Messages>(), Severity::warning,
                    "Nothing to simulate: the layout has no taxels. Ctrl+click on the mesh places a taxel, Ctrl+G "
                    "generates a pattern.",
                    ImGui::GetTime(), ui::Holds::while_unrunnable);
  return false;
}

void Studio::carry_out(const ui::SetMode& command) {
  const ui::Mode mode = command.mode;
  const bool runs = session_.shows_scene() || session_.frame() != nullptr;
  if (mode == ui::Mode::simulate && !session_.shows_scene() && !run_or_say_why_not() && !runs) return;
  if (mode == ui::Mode::simulate) session_.hand_over();
  framing_.checks_view = framing_.checks_view || app_.viewer->mode != mode;
  app_.viewer->mode = mode;
  rest_in_layout();
}

/// Pauses a run while LAYOUT is displayed. Back in SIMULATE the run that was paused so goes on.
void Studio::rest_in_layout() {
  if (app_.viewer->mode == ui::Mode::simulate) {
    if (std::exchange(outcome_.rests_in_layout, false)) session_.set_playing(true);
  } else if (session_.moves()) {
    outcome_.rests_in_layout = session_.playing();
    session_.set_playing(false);
  }
}

void Studio::save_screenshot(const std::string& file) {
  renderer_->draw_prepared();
  painter_->forget();
  fill_window();  // the objects of the last frame may be gone
  write_png(file, window_->read());
}

void Studio::save_numbered_screenshot() {
  try {
    const std::string name = free_name("screenshot-", ".png");
    save_screenshot(name);
    ui::add_message(app_.get<ui::Messages>(), Severity::note, "Saved " + std::filesystem::absolute(name).string(),
                    ImGui::GetTime());
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
}

void Studio::save_state(const std::string& file) {
  write_file_atomically(file, state_to_json(app_, pacing_.pace(app_.get<ui::ViewShown>().draws)));
  pacing_.reset(app_.get<ui::ViewShown>().draws);
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
  if (const auto* place = std::get_if<ViewTarget>(&target)) {
    const ui::Rect& view = app_.viewer->view.rect;
    return {std::round(view.x0 + static_cast<float>(place->u) * view.width()),
            std::round(view.y0 + static_cast<float>(place->v) * view.height())};
  }
  if (const auto* widget = std::get_if<WidgetTarget>(&target)) {
    const ui::WidgetRegistry::Entry* entry = app_.ui->widgets.find(widget->label);
    if (entry == nullptr) throw Error(fmt::format("no widget \"{}\" is visible", widget->label));
    return {entry->rect.center_x(), entry->rect.center_y()};
  }
  dvec3 p_W{0};
  if (const auto* world = std::get_if<WorldTarget>(&target)) p_W = world->p_W;
  if (const auto* wanted = std::get_if<TaxelTarget>(&target)) {
    const Layout* layout = app_.shown->layout(*app_.viewer);
    if (layout == nullptr) throw Error("no layout is open");
    const auto& taxels = layout->taxels;
    const auto taxel = std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == wanted->id; });
    if (taxel == taxels.end()) throw Error(fmt::format("there is no taxel {}", wanted->id));
    p_W = ui::shown_pose(*app_.viewer, *app_.shown) * taxel->center;
  }
  const dvec3 pixel = app_.viewer->project(p_W);
  const bool inside = pixel.z > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < app_.viewer->view.width &&
                      pixel.y < app_.viewer->view.height;
  if (!inside) throw Error("the point is outside of the view");
  return {app_.viewer->view.rect.x0 + static_cast<float>(pixel.x),
          app_.viewer->view.rect.y0 + static_cast<float>(pixel.y)};
}

ScriptStage Studio::script_stage() {
  ScriptStage stage;
  stage.locate = [this](const Target& target) { return locate(target); };
  stage.idle = [this] {
    const ui::FileDialog& dialog = app_.get<ui::FileDialog>();
    const bool asks_by_desktop = files_.desktop_dialog.is_open() || dialog.waits_for_desktop;
    return session_.idle() && !files_.comparison.busy() && input_taken() && app_.ui->commands.empty() && !video_ &&
           !asks_by_desktop && !dialog.wants_focus;
  };
  stage.running_time = [this]() -> std::optional<double> {
    const bool runs = session_.frame() && session_.playing() && !session_.frame()->finished;
    return runs ? std::optional<double>(session_.frame()->time) : std::nullopt;
  };
  stage.save_screenshot = [this](const std::string& file) { save_screenshot(file); };
  stage.save_state = [this](const std::string& file) { save_state(file); };
  stage.state = [this] { return state_to_json(app_, pacing_.pace(app_.get<ui::ViewShown>().draws)); };
  stage.quit = [this] { outcome_.quits = true; };
  return stage;
}

}  // namespace taxel::studio
