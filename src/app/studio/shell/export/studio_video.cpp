// Videos of the recorded steps: each step is displayed and saved as an image, at whatever rate frames are drawn.
#include <fmt/format.h>
#include <imgui_impl_opengl3.h>

#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/video/video_overlay.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/free_name.h"
#include "app/studio/shell/studio.h"
#include "app/studio/shell/window/png.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

namespace {

/// Draws notes over the bound framebuffer, as ImGui draws a window.
void draw_notes(int width, int height, const ui::VideoNotes& notes) {
  ImDrawList list(ImGui::GetDrawListSharedData());
  const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
  list._ResetForNewFrame();
  list.PushTexture(ImGui::GetIO().Fonts->TexRef);
  list.PushClipRect({0, 0}, size);
  ui::draw_video_notes(list, width, height, notes);
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

}  // namespace

StepRange Studio::steps_for_video() const {
  const HistoryState& history = app_.shown->run.frame->history;
  const std::optional<StepRange>& loop = app_.shown->run.loop;
  if (!loop) return {history.first, history.last};
  return {std::max(loop->first, history.first), std::min(loop->last, history.last)};
}

void Studio::carry_out(const ui::MakeFilm&) {
  if (!app_.shown->run.has_history()) {
    ui::add_message(app_.get<ui::Messages>(), Severity::warning,
                    "There is no recorded step to make a film of. Space runs the scenario.", ImGui::GetTime());
    return;
  }
  begin_video(plan_film(free_name("film-", ".mp4"), steps_for_video(), app_.get<ui::VideoState>()));
}

void Studio::begin_video(VideoPlan plan) {
  const bool is_film = plan.path.starts_with("film-");
  session_.set_playing(false);
  app_.viewer->mode = ui::Mode::simulate;  // the mode that displays steps
  film_camera_.reset();
  if (plan.orbit) film_camera_.emplace(app_.viewer->camera());
  if (plan.window) plan.width = window_->width(), plan.height = window_->height();
  const std::string path = plan.path;
  try {
    video_.emplace(std::move(plan), app_.shown->run.frame->step);
    const std::string sample = video_->sample_file();
    if (!sample.empty()) write_png(sample, black_image(video_->plan().width, video_->plan().height));
  } catch (const Error& error) {
    video_.reset();
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
    if (!is_film) ask_for_file(ui::FileTask::export_video, shown_message(error));
  }
}

/// Returns the image of the displayed step for the video that is being made.
gl::RgbImage Studio::video_image() {
  const VideoPlan& plan = video_->plan();
  if (plan.window) {
    painter_->forget();
    fill_window();  // the last frame may be gone
    return window_->read();
  }
  const bool as_view = plan.width == app_.viewer->view.width && plan.height == app_.viewer->view.height;
  if (as_view && !plan.annotated && !plan.orbit) return renderer_->picture();
  ui::SceneInput scene = ui::scene_input(app_);
  if (app_.viewer->view.height > 0)
    scene.scale *= std::max(1.0, static_cast<double>(plan.height) / app_.viewer->view.height);
  const SimFrame& frame = *app_.shown->run.frame;
  const ui::Camera camera =
      film_camera_ ? film_camera_->next(video_->fraction(), ui::contact_center(frame)) : app_.viewer->camera();
  const ui::VideoNotes notes{fmt::format("{:.3f} s", frame.time),
                             app_.shown->state(*app_.viewer) != nullptr ? &app_.viewer->range : nullptr, app_.ui->dark};
  app_.get<ui::ViewShown>().drawn = false;  // the image is drawn over the view's
  return renderer_->image(scene, camera, plan.width, plan.height, [&] {
    if (plan.annotated) draw_notes(plan.width, plan.height, notes);
  });
}

void Studio::make_video() {
  if (!video_) return;
  pacing_.request(1);
  try {
    if (!video_->is_ready()) return;
    const std::optional<std::uint64_t> wanted = video_->wanted();
    if (wanted) {
      const HistoryState& history = app_.shown->run.frame->history;
      if (session_.playing() || *wanted < history.first || *wanted > history.last)
        throw Error("The video is not made: the simulation ran on.");
      if (app_.shown->run.frame->step != *wanted) return session_.scrub(*wanted);
      write_png(video_->next_file(), video_image());
      video_->taken();
      if (video_->wanted()) session_.scrub(*video_->wanted());
      return;
    }
    const std::optional<VideoMade> made = video_->finish();
    if (!made) return;
    ui::add_message(app_.get<ui::Messages>(), made->complete ? Severity::note : Severity::warning, made->text,
                    ImGui::GetTime());
    session_.scrub(video_->shown_before());
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
  video_.reset();
}

}  // namespace taxel::studio
