#include "app/studio/nouns/video/video_commands.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/host.h"
#include "app/studio/host/png.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_notes.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/base/error.h"
#include "core/base/os/find_program.h"
#include "core/base/text/message.h"
#include "core/run/history/contact_steps.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {
namespace {

constexpr double kFollow = 0.08;  // fraction of the way to the contact by which each frame moves the target

}  // namespace

Camera FilmCamera::next(double fraction, const std::optional<dvec3>& contact_W) {
  if (contact_W) target_ = begun_ ? glm::mix(target_, *contact_W, kFollow) : *contact_W;
  begun_ = true;
  Camera camera = first_;
  camera.target = target_;
  camera.azimuth_deg = std::remainder(first_.azimuth_deg + 360 * fraction, 360.0);
  return camera;
}

}  // namespace taxel::ui

namespace taxel::studio {
namespace {

/// Draws notes over the bound framebuffer, as ImGui draws a window.
void draw_over_image(int width, int height, const ui::VideoNotes& notes) {
  ImDrawList list(ImGui::GetDrawListSharedData());
  const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
  list._ResetForNewFrame();
  list.PushTexture(ImGui::GetIO().Fonts->TexRef);
  list.PushClipRect({0, 0}, size);
  ui::draw_video_notes(list, size, notes);
  list.PopClipRect();
  list.PopTexture();
  ImDrawData data;
  data.Valid = true;
  data.DisplaySize = size;
  data.FramebufferScale = {1, 1};
  data.Textures = &ImGui::GetPlatformIO().Textures;  // glyphs of a new size are sent to the graphics card
  data.AddDrawList(&list);
  ImGui_ImplOpenGL3_RenderDrawData(&data);
}

gl::RgbImage black_image(int width, int height) {
  return {width, height, std::vector<unsigned char>(std::size_t{3} * static_cast<std::size_t>(width * height))};
}

/// Returns the force on the selected sensor, with its name if there are several; empty without a sensor.
std::string force_text(const ui::App& app) {
  const SensorStep* sensor = app.shown->state(*app.viewer);
  if (sensor == nullptr) return "";
  const std::vector<ui::BarGroup> groups = ui::bar_groups(*app.viewer, *app.shown, false);
  const std::string on =
      groups.size() > 1 ? " on " + ui::selected_group(groups, app.viewer->selection).name : std::string();
  return fmt::format("force{} {:.2f} N", on, glm::length(sensor->force_W));
}

/// Returns the notes of the displayed step.
ui::VideoNotes notes_of(const ui::App& app, const VideoPlan& plan) {
  ui::VideoNotes notes;
  notes.dark = app.ui->dark;
  notes.selection = app.viewer->selection;
  const bool has_readings = app.shown->state(*app.viewer) != nullptr;
  if (plan.annotated) {
    notes.time = fmt::format("{:.3f} s", app.shown->run.frame->time);
    notes.force = force_text(app);
    if (has_readings)
      notes.legend = {app.viewer->range, ui::reading_range(*app.viewer, *app.shown),
                      ui::unit_of_readings(*app.viewer, *app.shown), ui::shares_range(*app.viewer, *app.shown)};
  }
  if (plan.bars) notes.bars = ui::bar_groups(*app.viewer, *app.shown, false);
  return notes;
}

/// Returns the image of the displayed step for the video that is being made.
gl::RgbImage video_image(Host& host) {
  VideoJob& job = host.app.get<VideoJob>();
  const VideoPlan& plan = job.maker->plan();
  if (plan.window) return host.screen.picture();
  const bool as_view = plan.width == host.app.viewer->view.width && plan.height == host.app.viewer->view.height;
  if (as_view && !plan.annotated && !plan.bars && !plan.orbit) return host.screen.renderer->picture();
  ui::SceneInput scene = ui::scene_input(host.app);
  if (host.app.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(plan.height) / host.app.viewer->view.height);
  const SimFrame& frame = *host.app.shown->run.frame;
  const ui::Camera camera =
      job.camera ? job.camera->next(job.maker->fraction(), ui::contact_center(frame)) : host.app.viewer->camera();
  const ui::VideoNotes notes = notes_of(host.app, plan);
  host.app.get<ui::ViewShown>().drawn = false;  // the image is drawn over the view's
  return host.screen.renderer->image(scene, camera, plan.width, plan.height, [&] {
    if (plan.annotated || plan.bars) draw_over_image(plan.width, plan.height, notes);
  });
}

}  // namespace

std::optional<StepRange> steps_between(const HistoryLanes& lanes, const StepRange& within, double from, double to) {
  // Typed times have fewer digits than those of the steps.
  constexpr double kRounding = 1e-6;  // [s]
  std::optional<StepRange> range;
  for (std::size_t row = 0; row < lanes.rows(); ++row) {
    const StepMark& mark = lanes.steps[row];
    const bool is_inside = mark.step >= within.first && mark.step <= within.last;
    if (!is_inside || mark.time < from - kRounding || mark.time > to + kRounding) continue;
    range = StepRange{range ? range->first : mark.step, mark.step};
  }
  return range;
}

ui::VideoSource video_source(const ui::App& app) {
  constexpr double kMargin = 0.1;  // of the part with contact, on either side [s]
  ui::VideoSource source;
  source.width = app.viewer->view.width;
  source.height = app.viewer->view.height;
  source.has_encoder = os::has_program("ffmpeg");
  if (!app.shown->run.has_history()) return source;
  const ui::RunView& run = app.shown->run;
  const HistoryState& history = run.frame->history;
  source.steps = {history.first, history.last};
  if (run.loop) source.steps = {std::max(run.loop->first, history.first), std::min(run.loop->last, history.last)};
  source.contact = contact_steps(*history.lanes, source.steps, kMargin);
  const ui::VideoState& settings = app.get<ui::VideoState>();
  source.period = steps_between(*history.lanes, source.steps, settings.from, settings.to);
  source.begin = history.lanes->steps[history.lanes->row_of(source.steps.first)].time;
  source.end = history.lanes->steps[history.lanes->row_of(source.steps.last)].time;
  if (run.frame->scene) source.timestep = run.frame->scene->timestep;
  return source;
}

void begin_video(Host& host, VideoPlan plan) {
  VideoJob& job = host.app.get<VideoJob>();
  const bool is_film = plan.path.starts_with("film-");
  set_playing(host, false);
  if (!ui::shows_run(host.app.viewer->mode)) ui::enter_mode(host.app, ui::Mode::simulate);
  job.camera.reset();
  if (plan.orbit) job.camera.emplace(host.app.viewer->camera());
  if (plan.window) {
    plan.width = static_cast<int>(ImGui::GetIO().DisplaySize.x);
    plan.height = static_cast<int>(ImGui::GetIO().DisplaySize.y);
  }
  const std::string path = plan.path;
  try {
    job.maker = std::make_shared<VideoMaker>(std::move(plan), host.app.shown->run.frame->step, host.executor);
    const std::string sample = job.maker->sample_file();
    if (!sample.empty()) write_png(sample, black_image(job.maker->plan().width, job.maker->plan().height));
  } catch (const Error& error) {
    job.maker.reset();
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    if (!is_film) ask_for_file(host.app, ui::FileTask::export_video, shown_message(error));
  }
}

void carry_out(const ui::CancelVideo&, Host& host) {
  host.app.get<VideoJob>().maker.reset();
}

void carry_out(const ui::MakeFilm&, Host& host) {
  if (!host.app.shown->run.has_history()) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                    "There is no recorded step to make a film of. Space runs the scenario.", ImGui::GetTime());
    return;
  }
  ui::VideoState& settings = host.app.get<ui::VideoState>();
  settings.source = video_source(host.app);
  const std::string name = free_name("film-", settings.source.has_encoder ? ".mp4" : ".webp");
  if (settings.steps == ui::VideoSteps::period && !settings.source.period) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning, why_no_video(settings, name), ImGui::GetTime());
    return;
  }
  begin_video(host, plan_film(name, chosen_steps(settings), settings));
}

void make_video(Host& host) {
  VideoJob& job = host.app.get<VideoJob>();
  if (!job.maker) return;
  try {
    if (!job.maker->is_ready()) return;
    const std::optional<std::uint64_t> wanted = job.maker->wanted();
    if (wanted) {
      const HistoryState& history = host.app.shown->run.frame->history;
      if (host.run.playback.plays || *wanted < history.first || *wanted > history.last)
        throw Error("The video is not made: the simulation ran on.");
      if (host.app.shown->run.frame->step != *wanted) return scrub(host, *wanted);
      if (!job.maker->has_room()) return;
      job.maker->add(video_image(host));
      if (job.maker->wanted()) scrub(host, *job.maker->wanted());
      return;
    }
    const std::optional<VideoMade> made = job.maker->finish();
    if (!made) return;
    ui::add_message(host.app.get<ui::Messages>(), made->complete ? Severity::note : Severity::warning, made->text,
                    ImGui::GetTime());
    scrub(host, job.maker->shown_before());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
  job.maker.reset();
}

}  // namespace taxel::studio
