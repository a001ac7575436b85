#include "app/studio/features/scenario/path_recorder.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/features/scenario/path_tool.h"
#include "core/document/scenario/recorded_path.h"

namespace taxel::ui {

namespace {

void finish(UiState& ui, const UiInput& input) {
  PathRecording recording = std::move(*ui.path.recording);
  ui.path.recording.reset();
  std::vector<WayPoint>& points = recording.points;
  if (!points.empty() && recording.last.time > points.back().time) points.push_back(recording.last);
  if (points.size() < 2) {
    const char* const text = "The tool did not move while its path was recorded: the scenario stays as it is.";
    return add_message(ui, Severity::note, text, ImGui::GetTime());
  }
  const std::string text =
      fmt::format("Recorded a path of {} way points in {:.2f} s.", points.size(), points.back().time);
  add_message(ui, Severity::note, text, ImGui::GetTime());
  const Scenario edited = path_of_run(*edited_scenario(ui, input), input.scenario, std::move(points));
  ui.path.chosen.reset();
  ui.path.selected = -1;
  ui.ask(EditProject{SetScenario{edited}, {}});
}

/// How much later this picture is than the one before [s].
double time_since(const UiState& ui, const PathRecording& recording, double time) {
  if (recording.time && time > *recording.time) return time - *recording.time;
  return ui.perturb.kind != Perturb::Kind::none ? static_cast<double>(ImGui::GetIO().DeltaTime) : 0;
}

/// Where a scenario leads the tool, which lags a little under load; where nothing leads it, or a hand holds it, where
/// it is.
Pose led_to(const UiState& ui, const UiInput& input, bool goes_on) {
  const std::vector<Pose>& mocaps = input.frame->controls.mocaps;
  const bool led = goes_on && !mocaps.empty() && ui.perturb.kind == Perturb::Kind::none;
  return led ? mocaps.front() : input.sensor(ui)->X_WM;
}

}  // namespace

bool can_record_path(const UiState& ui, const UiInput& input) {
  return edited_scenario(ui, input) != nullptr && input.sensor(ui) != nullptr;
}

void toggle_path_recording(UiState& ui, const UiInput& input) {
  if (ui.path.recording) return finish(ui, input);
  PathRecording& recording = ui.path.recording.emplace();
  recording.runs = input.frame->runs;
  recording.over = input.frame->finished;
}

void follow_path_recording(UiState& ui, const UiInput& input) {
  std::optional<PathRecording>& recording = ui.path.recording;
  if (!recording || !can_record_path(ui, input)) return;
  const SimFrame& frame = *input.frame;
  if (frame.runs != recording->runs && recording->points.size() < 2) {  // it was to be of the run that begins now
    recording.emplace();
    recording->runs = frame.runs;
  }
  if (frame.runs != recording->runs) return finish(ui, input);
  if (frame.recorded) return recording->time.reset();
  const bool goes_on = recording->time && frame.time > *recording->time;
  const double later = time_since(ui, *recording, frame.time);
  recording->time = frame.time;
  recording->clock += later;
  if (later > 0 || recording->points.empty()) recording->last = {recording->clock, led_to(ui, input, goes_on)};
  std::vector<WayPoint>& points = recording->points;
  if (points.empty() || recording->clock >= points.back().time + ui.path.record_every)
    points.push_back(recording->last);
  if (frame.finished && !recording->over) return finish(ui, input);
  recording->over = frame.finished;
}

void leave_path(UiState& ui) {
  ui.path.recording.reset();
  ui.path.last.clear();
}

void let_go_of_way_points(UiState& ui) {
  PathState path;
  path.record_every = ui.path.record_every;
  path.recording = std::move(ui.path.recording);
  path.last = std::move(ui.path.last);
  ui.path = std::move(path);
}

}  // namespace taxel::ui
