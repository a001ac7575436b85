// Carries out the posted commands; files that the program writes at its end; and the program as scripts see it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/png.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/messages/messages.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/interface/dock_layout.h"
#include "app/studio/shell/state/settings.h"
#include "app/studio/shell/state/state_json.h"
#include "app/studio/shell/studio.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/message.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::studio {
namespace {

/// Returns the pixel of a target. Throws Error if it is not in the window.
ImVec2 locate(const ui::App& app, const Target& target) {
  if (const auto* pixel = std::get_if<PixelTarget>(&target)) {
    return {static_cast<float>(pixel->x), static_cast<float>(pixel->y)};
  }
  if (const auto* place = std::get_if<ViewTarget>(&target)) {
    const ui::Rect& view = app.viewer->view.rect;
    return {std::round(view.x0 + static_cast<float>(place->u) * view.width()),
            std::round(view.y0 + static_cast<float>(place->v) * view.height())};
  }
  if (const auto* widget = std::get_if<WidgetTarget>(&target)) {
    const ui::WidgetRegistry::Entry* entry = app.ui->widgets.find(widget->label);
    if (entry == nullptr) throw Error(fmt::format("no widget \"{}\" is visible", widget->label));
    return {entry->rect.center_x(), entry->rect.center_y()};
  }
  dvec3 p_W{0};
  if (const auto* world = std::get_if<WorldTarget>(&target)) p_W = world->p_W;
  if (const auto* wanted = std::get_if<TaxelTarget>(&target)) {
    const Layout* layout = app.shown->layout(*app.viewer);
    if (layout == nullptr) throw Error("no layout is open");
    const auto& taxels = layout->taxels;
    const auto taxel = std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == wanted->id; });
    if (taxel == taxels.end()) throw Error(fmt::format("there is no taxel {}", wanted->id));
    p_W = ui::shown_pose(*app.viewer, *app.shown) * taxel->center;
  }
  const dvec3 pixel = app.viewer->project(p_W);
  const bool inside = pixel.z > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < app.viewer->view.width &&
                      pixel.y < app.viewer->view.height;
  if (!inside) throw Error("the point is outside of the view");
  return {app.viewer->view.rect.x0 + static_cast<float>(pixel.x),
          app.viewer->view.rect.y0 + static_cast<float>(pixel.y)};
}

}  // namespace

/// An interface command acts together with the commands that it posts, before later commands.
void Studio::carry_out_commands() {
  std::vector<ui::Command> commands;
  commands.swap(app_.ui->commands);
  for (const ui::Command& posted : commands) {
    if (hold_if_unsaved(host_, posted)) continue;
    if (!posted.is_about_interface()) {
      posted.carry_out(host_);
      continue;
    }
    std::vector<ui::Command> later;
    later.swap(app_.ui->commands);
    posted.carry_out(app_);
    carry_out_commands();
    later.insert(later.end(), app_.ui->commands.begin(), app_.ui->commands.end());
    app_.ui->commands = std::move(later);
  }
}

void Studio::save_screenshot(const std::string& file) {
  renderer_->draw_prepared();
  write_png(file, window_picture());
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
  write_file_atomically(file, state());
  pacing_.reset(app_.get<ui::ViewShown>().draws);
}

void Studio::finish_outputs() {
  if (!options_.screenshot.empty()) save_screenshot(options_.screenshot);
  if (!options_.dump_state.empty()) save_state(options_.dump_state);
  if (!options_.cut_out.empty()) {
    write_png(options_.cut_out, cut_out(host_, options_.cut_out_width, options_.cut_out_height));
  }
}

ScriptStage Studio::script_stage() {
  ScriptStage stage;
  stage.locate = [this](const Target& target) { return locate(app_, target); };
  stage.idle = [this] {
    const ui::FileDialog& dialog = app_.get<ui::FileDialog>();
    const bool asks_by_desktop = desktop_dialog_.is_open() || dialog.waits_for_desktop;
    return host_.is_idle() && !host_.files.comparison.busy() && input_taken() && app_.ui->commands.empty() &&
           !app_.get<VideoJob>().maker && !asks_by_desktop && !dialog.wants_focus;
  };
  stage.works = [this] { return !host_.is_idle() || timing_.executor->busy(); };
  stage.running_time = [this]() -> std::optional<double> {
    const bool runs = host_.run.frame && host_.run.playback.plays && !host_.run.frame->finished;
    return runs ? std::optional<double>(host_.run.frame->time) : std::nullopt;
  };
  stage.save_screenshot = [this](const std::string& file) { save_screenshot(file); };
  stage.save_state = [this](const std::string& file) { save_state(file); };
  stage.state = [this] { return state(); };
  stage.quit = [this] { app_.get<ui::WindowState>().quits = true; };
  return stage;
}

std::string Studio::state() const {
  return state_to_json(app_, pacing_.pace(app_.get<ui::ViewShown>().draws));
}

/// The last frame may be gone, so that the window is drawn again.
gl::RgbImage Studio::window_picture() {
  painter_->forget();
  fill_window();
  return window_->read();
}

// Settings that the window keeps from one start to the next.

namespace {

/// Files of the arrangements of the modes. Earlier versions had one for all, window.ini, which is left alone.
constexpr std::array kArrangements = {"arrangement-layout.ini", "arrangement-simulate.ini", "arrangement-analyse.ini"};

/// Returns the path of a file in the settings folder.
std::filesystem::path kept_file(const Options& options, const char* name) {
  return (options.state_dir.empty() ? settings_folder() : std::filesystem::path(options.state_dir)) / name;
}

}  // namespace

void load_settings(const Options& options, Window& window, ui::App& app) {
  const auto put_aside = [&](const std::filesystem::path& file, const std::string& why) {
    const std::filesystem::path aside = file.string() + ".broken";
    std::error_code failed;
    std::filesystem::rename(file, aside, failed);
    ui::add_message(app.get<ui::Messages>(), Severity::warning,
                    fmt::format("{}: what could not be read is as in a new installation{}", why,
                                failed ? "" : fmt::format("; the file is kept as {}", aside.filename().string())),
                    ImGui::GetTime());
  };
  const std::string problem = read_settings(kept_file(options, "settings.json"), app);
  if (!options.has_size) window.set_place(app.get<ui::WindowState>().place);
  if (!problem.empty()) put_aside(kept_file(options, "settings.json"), problem);
  std::error_code ignored;
  for (std::size_t mode = 0; mode < kArrangements.size(); ++mode) {
    const std::filesystem::path file = kept_file(options, kArrangements[mode]);
    if (!std::filesystem::exists(file, ignored)) continue;
    try {
      app.get<ui::Arrangement>().kept[mode] = read_file(file);
    } catch (const Error& error) {
      put_aside(file, shown_message(error));
    }
  }
}

void save_settings(const Options& options, Window& window, ui::App& app) {
  try {
    if (const auto place = window.place()) app.get<ui::WindowState>().place = *place;
    write_settings(kept_file(options, "settings.json"), app);
    const std::array<std::string, 3> texts = ui::arrangement_texts(app);
    for (std::size_t mode = 0; mode < kArrangements.size(); ++mode)
      if (!texts[mode].empty()) write_file_atomically(kept_file(options, kArrangements[mode]), texts[mode]);
  } catch (const Error& error) {
    std::fprintf(stderr, "taxelstudio: settings are not kept: %s\n", shown_message(error).c_str());
  }
}

}  // namespace taxel::studio
