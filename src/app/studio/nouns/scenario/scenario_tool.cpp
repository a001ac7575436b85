// Editing of a path's waypoints in the 3-D view, and recording of waypoints from the motion of the tool.
#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/document/scenario/path.h"
#include "ui/scene/scene_input.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr double kGlyphReach = 10;    // distance at which a glyph is grabbed, at scale 1 [pixels]
constexpr double kMoreSeconds = 0.5;  // time from the last waypoint to a waypoint added at the end
constexpr int kLineParts = 160;

const Scenario* path_of(const Viewer& viewer, const Shown& shown) {
  const Scenario* scenario = edited_scenario(viewer, shown);
  return scenario != nullptr && scenario->is<scenarios::Path>() ? scenario : nullptr;
}

/// Returns the waypoints of a path.
template <class S>
auto& points_of(S& scenario) {
  return scenario.template as<scenarios::Path>().points;
}

/// Returns the index of the waypoint whose glyph is under the pointer, or -1. The selected waypoint comes first,
/// because others may be in the same place; then the nearest one.
int mark_at(const WindowUi& ui, const Viewer& viewer, const ShownPath& path, const dvec2& pointer) {
  int nearest = -1;
  double least = kGlyphReach * ui.pixel_scale;
  for (std::size_t i = 0; i < path.points_W.size(); ++i) {
    const dvec3 pixel = viewer.project(path.points_W[i]);
    const double distance = glm::distance(dvec2(pixel.x, pixel.y), pointer);
    if (!(pixel.z > 0 && distance < least)) continue;
    nearest = static_cast<int>(i);
    least = nearest == path.selected ? 0 : distance;
  }
  return nearest;
}

/// Returns the vector from one pixel to another in the plane through a point that faces the camera.
dvec3 across_view(const Viewer& viewer, const dvec3& p_W, const dvec2& from, const dvec2& to) {
  const Camera& camera = viewer.camera();
  const dvec3 forward = glm::normalize(camera.target - camera.eye());
  const auto under = [&](const dvec2& pixel) {
    const Ray ray = camera.pixel_ray(pixel.x, pixel.y, viewer.view.width, viewer.view.height);
    const double far = glm::dot(p_W - ray.origin, forward) / glm::dot(ray.direction, forward);
    return ray.origin + far * ray.direction;
  };
  return under(to) - under(from);
}

/// Returns the edit that moves the selected waypoint.
Edit moved_by(const PathState& path, const Scenario& scenario, const dvec3& by_W) {
  Scenario moved = scenario;
  points_of(moved)[static_cast<std::size_t>(path.selected)].X_WM.p = path.was->X_WM.p + by_W;
  return SetScenario{moved};
}

void drag(WindowUi& ui, const Viewer& viewer, ToolState& tool, PathState& path, const Scenario& scenario,
          const dvec2& pointer) {
  if (static_cast<std::size_t>(path.selected) >= points_of(scenario).size()) return;
  if (!path.moved) path.gesture = ++tool.gesture;
  path.moved = true;
  const dvec3 by_W = across_view(viewer, path.grabbed_W, path.start, pointer);
  ui.post(EditProject{moved_by(path, scenario, by_W), {path.gesture, true}});
}

}  // namespace

const Scenario* edited_scenario(const Viewer& viewer, const Shown& shown) {
  const bool runs = shows_run(viewer.mode) && shown.run.runs_scenario && shown.run.frame && shown.run.frame->scene;
  return runs && shown.document.editing.project ? &shown.document.editing.project->scenario : nullptr;
}

std::optional<ShownPath> edited_path(const Viewer& viewer, const Shown& shown, const PathState& state) {
  const Scenario* scenario = path_of(viewer, shown);
  if (scenario == nullptr || points_of(*scenario).empty()) return std::nullopt;
  const dvec3 lead_M = shown.run.frame->scene->lead_M;
  const PathCurve curve(points_of(*scenario));
  ShownPath path;
  path.selected = state.selected;
  for (const WayPoint& point : points_of(*scenario)) path.points_W.push_back(point.X_WM * lead_M);
  for (int i = 0; i <= kLineParts; ++i)
    path.line_W.push_back(curve.at(curve.begin() + (curve.end() - curve.begin()) * i / kLineParts) * lead_M);
  return path;
}

std::vector<WayPoint> points_to_begin_with(const Viewer& viewer, const Shown& shown) {
  std::vector<WayPoint> points;
  if (shown.run.frame && shown.run.frame->scene) points = shown.run.frame->scene->way_points;
  if (points.size() >= 2) return points;
  const SensorStep* sensor = shown.sensor(viewer);
  const Pose X_WM = sensor != nullptr ? sensor->X_WM : Pose{};
  return {{0, X_WM}, {kMoreSeconds, X_WM}};
}

void add_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path) {
  const Scenario* scenario = path_of(viewer, shown);
  const SensorStep* sensor = shown.sensor(viewer);
  if (scenario == nullptr || sensor == nullptr) return;
  const int last = static_cast<int>(points_of(*scenario).size()) - 1;
  const int after = path.selected >= 0 && path.selected <= last ? path.selected : last;
  Scenario edited = *scenario;
  std::vector<WayPoint>& points = points_of(edited);
  const auto at = static_cast<std::size_t>(after + 1);
  double time = after < 0 ? 0 : points[at - 1].time + kMoreSeconds;
  if (after >= 0 && after < last) time = 0.5 * (points[at - 1].time + points[at].time);
  points.insert(points.begin() + (after + 1), WayPoint{time, sensor->X_WM});
  path.selected = after + 1;
  ui.post(EditProject{SetScenario{edited}, {}});
}

void delete_way_point(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path) {
  const Scenario* scenario = path_of(viewer, shown);
  const auto i = static_cast<std::size_t>(path.selected);
  if (scenario == nullptr || path.selected < 0 || i >= points_of(*scenario).size() || points_of(*scenario).size() <= 2)
    return;
  Scenario edited = *scenario;
  points_of(edited).erase(points_of(edited).begin() + path.selected);
  path.selected = -1;
  ui.post(EditProject{SetScenario{edited}, {}});
}

bool has_way_point(const Viewer& viewer, const Shown& shown, const PathState& path) {
  const Scenario* scenario = path_of(viewer, shown);
  return scenario != nullptr && path.selected >= 0 &&
         static_cast<std::size_t>(path.selected) < points_of(*scenario).size();
}

bool take_way_point(const Viewer& viewer, const Shown& shown, PathState& path) {
  if (!has_way_point(viewer, shown, path)) return false;
  path.was = points_of(*path_of(viewer, shown))[static_cast<std::size_t>(path.selected)];
  path.grabbed_W = path.was->X_WM * shown.run.frame->scene->lead_M;
  return true;
}

GestureEdit moved_way_point(const Viewer& viewer, const Shown& shown, const ToolState& tool, const PathState& path) {
  if (!has_way_point(viewer, shown, path)) return {};
  const Scenario& scenario = *path_of(viewer, shown);
  if (tool.input.axis < 0 && !typed_number(tool.input.typed)) {
    dvec3 by_W = across_view(viewer, path.grabbed_W, tool.pointer_start, tool.input.pointer);
    for (int axis = 0; axis < 3; ++axis) by_W[axis] = snapped_length(by_W[axis], tool.input);
    return {moved_by(path, scenario, by_W), in_mm(glm::length(by_W))};
  }
  const int axis = std::max(0, tool.input.axis);
  const GestureView view{viewer.camera(), viewer.view.width, viewer.view.height, Pose{}, nullptr};
  dvec3 by_W(0);
  by_W[axis] = distance_along(tool.input, tool.pointer_start, view, path.grabbed_W, axis);
  return {moved_by(path, scenario, by_W), along_text(by_W[axis], axis)};
}

void cancel_way_point_drag(WindowUi& ui, PathState& path) {
  if (path.held && path.moved) ui.post(CancelGesture{path.gesture});
  path.held = false;
}

bool handle_path_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, PathState& state,
                       const PointerEvent& event) {
  const Scenario* scenario = path_of(viewer, shown);
  if (scenario == nullptr || !viewer.overlays().path) {
    state.held = false;
    return false;
  }
  if (state.held && event.left().down) {
    if (state.moved || event.left().dragged()) drag(ui, viewer, tool, state, *scenario, event.at);
    return true;
  }
  if (state.held) {
    if (state.moved) ui.post(EndGesture{});
    state.held = false;
    return true;
  }
  if (!event.hovered || event.ctrl || event.shift || !event.left().pressed) return false;
  const ShownPath path = *edited_path(viewer, shown, state);
  const int mark = mark_at(ui, viewer, path, event.at);
  if (mark < 0) return false;
  const auto i = static_cast<std::size_t>(mark);
  state.selected = mark;
  state.held = true;
  state.moved = false;
  state.start = event.at;
  state.grabbed_W = path.points_W[i];
  state.was = points_of(*scenario)[i];
  return true;
}

namespace {

bool point_path(App& app, const PointerEvent& event) {
  return handle_path_mouse(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>(), event);
}

}  // namespace

constinit const Feature kPath{
    .tool = {"path", kEverywhere, point_path, 11, [](const App& app) { return app.get<PathState>().held; },
             [](App& app) { cancel_way_point_drag(*app.ui, app.get<PathState>()); }},
    .mark = [](const App& app,
               SceneInput& scene) { scene.path = edited_path(*app.viewer, *app.shown, app.get<PathState>()); },
};

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
