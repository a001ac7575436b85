#include "app/studio/nouns/scenario/path_recorder.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/path_tool.h"
#include "core/document/scenario/recorded_path.h"

namespace taxel::ui {

namespace {

void finish(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages) {
  PathRecording recording = std::move(*path.recording);
  path.recording.reset();
  std::vector<WayPoint>& points = recording.points;
  if (!points.empty() && recording.last.time > points.back().time) points.push_back(recording.last);
  if (points.size() < 2) {
    const char* const text = "The tool did not move while its path was recorded: the scenario stays as it is.";
    return add_message(messages, Severity::note, text, ImGui::GetTime());
  }
  const std::string text =
      fmt::format("Recorded a path of {} way points in {:.2f} s.", points.size(), points.back().time);
  add_message(messages, Severity::note, text, ImGui::GetTime());
  const Scenario edited = path_of_run(*edited_scenario(viewer, shown), shown.run.scenario, std::move(points));
  path.chosen.reset();
  path.selected = -1;
  ui.post(EditProject{SetScenario{edited}, {}});
}

/// Returns the time between the previous frame and this frame [s].
double time_since(const PerturbState& perturb, const PathRecording& recording, double time) {
  if (recording.time && time > *recording.time) return time - *recording.time;
  return perturb.kind != Perturb::Kind::none ? static_cast<double>(ImGui::GetIO().DeltaTime) : 0;
}

/// Returns the pose to which a scenario moves the tool, because the tool lags a little under load. Returns the tool's
/// pose if no scenario moves the tool, or if the user has grabbed a body.
Pose led_to(const Viewer& viewer, const Shown& shown, const PerturbState& perturb, bool goes_on) {
  const std::vector<Pose>& mocaps = shown.run.frame->controls.mocaps;
  const bool led = goes_on && !mocaps.empty() && perturb.kind == Perturb::Kind::none;
  return led ? mocaps.front() : shown.sensor(viewer)->X_WM;
}

void follow_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, const PerturbState& perturb,
                           PathState& path, Messages& messages) {
  std::optional<PathRecording>& recording = path.recording;
  if (!recording || !can_record_path(viewer, shown)) return;
  const SimFrame& frame = *shown.run.frame;
  if (frame.runs != recording->runs && recording->points.size() < 2) {  // too short: record the new run instead
    recording.emplace();
    recording->runs = frame.runs;
  }
  if (frame.runs != recording->runs) return finish(ui, viewer, shown, path, messages);
  if (frame.recorded) return recording->time.reset();
  const bool goes_on = recording->time && frame.time > *recording->time;
  const double later = time_since(perturb, *recording, frame.time);
  recording->time = frame.time;
  recording->clock += later;
  if (later > 0 || recording->points.empty())
    recording->last = {recording->clock, led_to(viewer, shown, perturb, goes_on)};
  std::vector<WayPoint>& points = recording->points;
  if (points.empty() || recording->clock >= points.back().time + path.record_every) points.push_back(recording->last);
  if (frame.finished && !recording->over) return finish(ui, viewer, shown, path, messages);
  recording->over = frame.finished;
}

}  // namespace

bool can_record_path(const Viewer& viewer, const Shown& shown) {
  return edited_scenario(viewer, shown) != nullptr && shown.sensor(viewer) != nullptr;
}

void toggle_path_recording(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path,
                           Messages& messages) {
  if (path.recording) return finish(ui, viewer, shown, path, messages);
  PathRecording& recording = path.recording.emplace();
  recording.runs = shown.run.frame->runs;
  recording.over = shown.run.frame->finished;
}

void let_go_of_way_points(PathState& path_state) {
  PathState path;
  path.record_every = path_state.record_every;
  path.recording = std::move(path_state.recording);
  path.last = std::move(path_state.last);
  path_state = std::move(path);
}

constinit const Feature kPathRecorder{
    .update =
        [](App& app) {
          follow_path_recording(*app.ui, *app.viewer, *app.shown, app.get<PerturbState>(), app.get<PathState>(),
                                app.get<Messages>());
        },
    .dump = dump_scenario,
};

void carry_out(const ToggleRecordPath&, App& app) {
  toggle_path_recording(*app.ui, *app.viewer, *app.shown, app.get<PathState>(), app.get<Messages>());
}

}  // namespace taxel::ui
