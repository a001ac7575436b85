#include "app/studio/features/scenario/path_tool.h"

#include <imgui.h>

#include "core/document/scenario/path_curve.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr double kReach = 10;         // of a mark, at scale 1 [pixels]
constexpr double kMoreSeconds = 0.5;  // from the last way point to one that is added behind it
constexpr int kLineParts = 160;

const Scenario* path_of(const UiState& ui, const UiInput& input) {
  const Scenario* scenario = edited_scenario(ui, input);
  return scenario != nullptr && scenario->is<scenarios::Path>() ? scenario : nullptr;
}

/// Returns the waypoints of a path.
template <class S>
auto& points_of(S& scenario) {
  return scenario.template as<scenarios::Path>().points;
}

/// The mark under the pointer: the selected one, for others may lie in the same place, else the nearest; -1: none.
int mark_at(const UiState& ui, const ShownPath& path, const dvec2& pointer) {
  int nearest = -1;
  double least = kReach * ui.pixel_scale;
  for (std::size_t i = 0; i < path.points_W.size(); ++i) {
    const dvec3 pixel = ui.camera().project(path.points_W[i], ui.view.width, ui.view.height);
    const double distance = glm::distance(dvec2(pixel.x, pixel.y), pointer);
    if (!(pixel.z > 0 && distance < least)) continue;
    nearest = static_cast<int>(i);
    least = nearest == path.selected ? 0 : distance;
  }
  return nearest;
}

/// From one pixel to another in the plane through a point that faces the camera.
dvec3 across_view(const UiState& ui, const dvec3& p_W, const dvec2& from, const dvec2& to) {
  const Camera& camera = ui.camera();
  const dvec3 forward = glm::normalize(camera.target - camera.eye());
  const auto under = [&](const dvec2& pixel) {
    const Ray ray = camera.pixel_ray(pixel.x, pixel.y, ui.view.width, ui.view.height);
    const double far = glm::dot(p_W - ray.origin, forward) / glm::dot(ray.direction, forward);
    return ray.origin + far * ray.direction;
  };
  return under(to) - under(from);
}

/// The path with its selected way point moved.
Edit moved_by(const UiState& ui, const Scenario& scenario, const dvec3& by_W) {
  Scenario moved = scenario;
  points_of(moved)[static_cast<std::size_t>(ui.path.selected)].X_WM.p = ui.path.was->X_WM.p + by_W;
  return SetScenario{moved};
}

void drag(UiState& ui, const Scenario& scenario, const dvec2& pointer) {
  PathState& state = ui.path;
  if (static_cast<std::size_t>(state.selected) >= points_of(scenario).size()) return;
  if (!state.moved) state.gesture = ++ui.tool.gesture;
  state.moved = true;
  const dvec3 by_W = across_view(ui, state.grabbed_W, state.start, pointer);
  ui.ask(EditProject{moved_by(ui, scenario, by_W), {state.gesture, true}});
}

}  // namespace

const Scenario* edited_scenario(const UiState& ui, const UiInput& input) {
  const bool runs = ui.mode == Mode::simulate && input.runs_scenario && input.frame && input.frame->scene;
  return runs && input.editing.project ? &input.editing.project->scenario : nullptr;
}

std::optional<ShownPath> edited_path(const UiState& ui, const UiInput& input) {
  const Scenario* scenario = path_of(ui, input);
  if (scenario == nullptr || points_of(*scenario).empty()) return std::nullopt;
  const dvec3 lead_M = input.frame->scene->lead_M;
  const PathCurve curve(points_of(*scenario));
  ShownPath path;
  path.selected = ui.path.selected;
  for (const WayPoint& point : points_of(*scenario)) path.points_W.push_back(point.X_WM * lead_M);
  for (int i = 0; i <= kLineParts; ++i)
    path.line_W.push_back(curve.at(curve.begin() + (curve.end() - curve.begin()) * i / kLineParts) * lead_M);
  return path;
}

std::vector<WayPoint> points_to_begin_with(const UiState& ui, const UiInput& input) {
  std::vector<WayPoint> points;
  if (input.frame && input.frame->scene) points = input.frame->scene->way_points;
  if (points.size() >= 2) return points;
  const SensorStep* sensor = input.sensor(ui);
  const Pose X_WM = sensor != nullptr ? sensor->X_WM : Pose{};
  return {{0, X_WM}, {kMoreSeconds, X_WM}};
}

void add_way_point(UiState& ui, const UiInput& input) {
  const Scenario* scenario = path_of(ui, input);
  const SensorStep* sensor = input.sensor(ui);
  if (scenario == nullptr || sensor == nullptr) return;
  const int last = static_cast<int>(points_of(*scenario).size()) - 1;
  const int after = ui.path.selected >= 0 && ui.path.selected <= last ? ui.path.selected : last;
  Scenario edited = *scenario;
  std::vector<WayPoint>& points = points_of(edited);
  const auto at = static_cast<std::size_t>(after + 1);
  double time = after < 0 ? 0 : points[at - 1].time + kMoreSeconds;
  if (after >= 0 && after < last) time = 0.5 * (points[at - 1].time + points[at].time);
  points.insert(points.begin() + (after + 1), WayPoint{time, sensor->X_WM});
  ui.path.selected = after + 1;
  ui.ask(EditProject{SetScenario{edited}, {}});
}

void delete_way_point(UiState& ui, const UiInput& input) {
  const Scenario* scenario = path_of(ui, input);
  const auto i = static_cast<std::size_t>(ui.path.selected);
  if (scenario == nullptr || ui.path.selected < 0 || i >= points_of(*scenario).size() ||
      points_of(*scenario).size() <= 2)
    return;
  Scenario edited = *scenario;
  points_of(edited).erase(points_of(edited).begin() + ui.path.selected);
  ui.path.selected = -1;
  ui.ask(EditProject{SetScenario{edited}, {}});
}

bool has_way_point(const UiState& ui, const UiInput& input) {
  const Scenario* scenario = path_of(ui, input);
  return scenario != nullptr && ui.path.selected >= 0 &&
         static_cast<std::size_t>(ui.path.selected) < points_of(*scenario).size();
}

bool take_way_point(UiState& ui, const UiInput& input) {
  if (!has_way_point(ui, input)) return false;
  ui.path.was = points_of(*path_of(ui, input))[static_cast<std::size_t>(ui.path.selected)];
  ui.path.grabbed_W = ui.path.was->X_WM * input.frame->scene->lead_M;
  return true;
}

GestureEdit moved_way_point(const UiState& ui, const UiInput& input) {
  if (!has_way_point(ui, input)) return {};
  const ToolState& tool = ui.tool;
  const Scenario& scenario = *path_of(ui, input);
  if (tool.input.axis < 0 && !typed_number(tool.input.typed)) {
    dvec3 by_W = across_view(ui, ui.path.grabbed_W, tool.pointer_start, tool.input.pointer);
    for (int axis = 0; axis < 3; ++axis) by_W[axis] = snapped_length(by_W[axis], tool.input);
    return {moved_by(ui, scenario, by_W), in_mm(glm::length(by_W))};
  }
  const int axis = std::max(0, tool.input.axis);
  const GestureView view{ui.camera(), ui.view.width, ui.view.height, Pose{}, nullptr};
  dvec3 by_W(0);
  by_W[axis] = distance_along(tool.input, tool.pointer_start, view, ui.path.grabbed_W, axis);
  return {moved_by(ui, scenario, by_W), along_text(by_W[axis], axis)};
}

void cancel_way_point_drag(UiState& ui) {
  if (ui.path.held && ui.path.moved) ui.ask(CancelGesture{ui.path.gesture});
  ui.path.held = false;
}

bool handle_path_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  PathState& state = ui.path;
  const Scenario* scenario = path_of(ui, input);
  if (scenario == nullptr || !ui.saved.overlays.path) {
    state.held = false;
    return false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  if (state.held && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    if (state.moved || ImGui::IsMouseDragging(ImGuiMouseButton_Left)) drag(ui, *scenario, {x, y});
    return true;
  }
  if (state.held) {
    if (state.moved) ui.ask(EndGesture{});
    state.held = false;
    return true;
  }
  if (!hovered || io.KeyCtrl || io.KeyShift || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return false;
  const ShownPath path = *edited_path(ui, input);
  const int mark = mark_at(ui, path, {x, y});
  if (mark < 0) return false;
  const auto i = static_cast<std::size_t>(mark);
  state.selected = mark;
  state.held = true;
  state.moved = false;
  state.start = {x, y};
  state.grabbed_W = path.points_W[i];
  state.was = points_of(*scenario)[i];
  return true;
}

}  // namespace taxel::ui
