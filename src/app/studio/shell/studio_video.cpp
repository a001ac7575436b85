// Videos of the recorded steps: each step is displayed and saved as an image, at whatever rate frames are drawn.
#include "app/studio/shell/studio.h"
#include "app/studio/shell/window/png.h"

namespace taxel::studio {

void Studio::begin_video(const std::string& path) {
  const HistoryState& history = app_.shown.run.frame->history;
  StepRange steps{history.first, history.last};
  if (app_.shown.run.loop)
    steps = {std::max(app_.shown.run.loop->first, steps.first), std::min(app_.shown.run.loop->last, steps.last)};
  session_.set_playing(false);
  app_.viewer.mode = ui::Mode::simulate;  // the mode that displays steps
  try {
    video_.emplace(path, steps, app_.simulate.video, app_.shown.run.frame->step);
  } catch (const Error& error) {
    ui::add_message(app_.window.messages, Severity::error, error.what(), ImGui::GetTime());
    ask_for_file(ui::FileTask::export_video, error.what());
  }
}

void Studio::make_video() {
  if (!video_) return;
  pacing_.request(1);
  try {
    const std::optional<std::uint64_t> wanted = video_->wanted();
    if (wanted) {
      const HistoryState& history = app_.shown.run.frame->history;
      if (session_.playing() || *wanted < history.first || *wanted > history.last)
        throw Error("The video is not made: the simulation ran on.");
      if (app_.shown.run.frame->step != *wanted) return session_.scrub(*wanted);
      if (video_->of_window()) {
        painter_->forget();
        fill_window();  // the last frame may be gone
      }
      write_png(video_->next_file(), video_->of_window() ? window_->read() : renderer_->picture());
      video_->taken();
      if (video_->wanted()) session_.scrub(*video_->wanted());
      return;
    }
    const std::optional<VideoMade> made = video_->finish();
    if (!made) return;
    ui::add_message(app_.window.messages, made->complete ? Severity::note : Severity::warning, made->text,
                    ImGui::GetTime());
    session_.scrub(video_->shown_before());
  } catch (const Error& error) {
    ui::add_message(app_.window.messages, Severity::error, error.what(), ImGui::GetTime());
  }
  video_.reset();
}

}  // namespace taxel::studio
