#include "app/studio/features/camera/camera_follow.h"

#include <algorithm>
#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/camera/sensor_in_view.h"
#include "app/studio/features/perturb/perturb_tool.h"

namespace taxel::ui {

namespace {

constexpr double kAzimuthDeg = -108, kElevationDeg = 15, kLayoutAzimuthDeg = -60;
/// The box around a whole path is larger than what there is to see at any time.
constexpr double kSweepCloseness = 0.7;
/// Most notches of the wheel by which the camera moves back: 170 times as far.
constexpr int kMaxStepsBack = 40;
/// MuJoCo's free camera stands this many extents away, and sees its own angle [degrees].
constexpr double kExtents = 1.5;
/// Nearest that a camera of the scene is taken to be to its middle, in sizes of the scene.
constexpr double kLeastDepth = 1e-3;

double half_tangent(double degrees) {
  return std::tan(0.5 * glm::radians(degrees));
}

bool simulated(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::simulate && input.frame && input.frame->scene;
}

const Pose* camera_pose(const UiState& ui, const UiInput& input) {
  const auto camera = static_cast<std::size_t>(ui.follow.camera);
  const bool there =
      simulated(ui, input) && ui.follow.camera >= 0 &&
      camera < std::min(input.frame->scene->marks.cameras.size(), input.frame->mark_poses.cameras.size());
  return there ? &input.frame->mark_poses.cameras[camera] : nullptr;
}

const Pose* body_pose(const UiInput& input, int body) {
  const auto b = static_cast<std::size_t>(body);
  return body >= 0 && b < input.frame->mark_poses.bodies.size() ? &input.frame->mark_poses.bodies[b] : nullptr;
}

double depth_of_scene(const UiState& ui, const UiInput& input, const Pose& X_WC) {
  const Aabb box = scene_box(ui, input);
  if (box.empty()) return 1;
  const dvec3 way = box.center() - X_WC.p;
  const double ahead = -glm::dot(way, X_WC.rotation()[2]);
  return std::max(ahead > 0 ? ahead : glm::length(way), kLeastDepth * box.diagonal());
}

}  // namespace

Camera first_camera(Mode mode) {
  Camera camera;
  camera.azimuth_deg = mode == Mode::layout ? kLayoutAzimuthDeg : kAzimuthDeg;
  camera.elevation_deg = kElevationDeg;
  return camera;
}

void frame_scene(UiState& ui, const UiInput& input) {
  Camera& camera = ui.camera();
  camera.frame(scene_box(ui, input));
  if (ui.mode == Mode::simulate && input.runs_scenario) camera.distance *= kSweepCloseness;
  if (ui.view.width <= 0 || ui.view.height <= 0) return;
  // A narrow view, or a sensor far from the middle of its path: the camera moves back until all of it is shown.
  const std::vector<BoxCorners> sensors = sensor_boxes(ui, input);
  const auto shows_all = [&] {
    return std::all_of(sensors.begin(), sensors.end(), [&](const BoxCorners& box) {
      return is_inside_view(box, camera, ui.view.width, ui.view.height);
    });
  };
  for (int i = 0; i < kMaxStepsBack && !shows_all(); ++i) camera.zoom(-1);
}

void align_camera(UiState& ui, const UiInput& input) {
  free_camera(ui);
  Camera& camera = ui.camera();
  camera = first_camera(ui.mode);
  frame_scene(ui, input);
  if (!simulated(ui, input) || !input.is_scene) return;
  const SceneOverview& overview = input.frame->scene->marks.overview;
  if (!(overview.extent > 0)) return;
  camera.target = overview.center_W;
  camera.azimuth_deg = std::remainder(overview.azimuth_deg, 360.0);
  camera.elevation_deg = overview.elevation_deg;
  camera.distance = kExtents * overview.extent * half_tangent(overview.fov_deg) / half_tangent(camera.fov_deg);
}

bool looks_through_camera(const UiState& ui) {
  return ui.mode == Mode::simulate && ui.follow.camera >= 0;
}

bool has_cameras(const UiState& ui, const UiInput& input) {
  return simulated(ui, input) && !input.frame->mark_poses.cameras.empty();
}

void look_through_next(UiState& ui, const UiInput& input, int direction) {
  const int count = static_cast<int>(input.frame->mark_poses.cameras.size());
  FollowState& follow = ui.follow;
  if (follow.camera < 0) follow.free = ui.camera();
  follow.body = -1;
  follow.camera = follow.camera < 0 ? (direction > 0 ? 0 : count - 1) : (follow.camera + direction + count) % count;
  if (const Pose* X_WC = camera_pose(ui, input)) follow.depth = depth_of_scene(ui, input, *X_WC);
}

void track_body(UiState& ui, const UiInput& input, const Pick& under) {
  free_camera(ui);
  ui.camera().target = under.position_W;
  const int geom = picked_geom(*input.frame->scene, under);
  if (geom < 0) return;
  const int body = input.frame->scene->geoms[static_cast<std::size_t>(geom)].body_index;
  const Pose* X_WB = body_pose(input, body);
  if (body == 0 || X_WB == nullptr) return;
  ui.follow.body = body;
  ui.follow.point_B = X_WB->inverse() * under.position_W;
  ui.follow.point_W = under.position_W;
}

void leave_followed(UiState& ui) {
  if (ui.follow.camera >= 0) ui.cameras[1] = ui.follow.free;
  ui.follow = {};
}

void free_camera(UiState& ui) {
  if (ui.mode == Mode::simulate) leave_followed(ui);
}

void follow_scene(UiState& ui, const UiInput& input) {
  FollowState& follow = ui.follow;
  if (!simulated(ui, input) || (follow.camera < 0 && follow.body < 0)) return;
  if (follow.camera >= 0) {
    const Pose* X_WC = camera_pose(ui, input);
    if (X_WC == nullptr) return leave_followed(ui);  // another scene
    const SceneCamera& from = input.frame->scene->marks.cameras[static_cast<std::size_t>(follow.camera)];
    ui.camera().look_from(*X_WC, follow.depth);
    ui.camera().fov_deg =
        from.orthographic ? glm::degrees(2 * std::atan(0.5 * from.height / follow.depth)) : from.height;
  } else if (const Pose* X_WB = body_pose(input, follow.body)) {
    const dvec3 now = *X_WB * follow.point_B;
    ui.camera().target += now - follow.point_W;
    follow.point_W = now;
  }
}

std::string follow_text(const UiState& ui, const UiInput& input) {
  if (!simulated(ui, input)) return {};
  const SimScene& scene = *input.frame->scene;
  const auto camera = static_cast<std::size_t>(ui.follow.camera), body = static_cast<std::size_t>(ui.follow.body);
  if (ui.follow.camera >= 0 && camera < scene.marks.cameras.size())
    return "Camera " + scene.marks.cameras[camera].name + "   [ ] others, Esc frees";
  if (ui.follow.body >= 0 && body < scene.controls.bodies.size())
    return "Tracks " + scene.controls.bodies[body].name + "   Esc frees";
  return {};
}

bool can_select_parent(const UiState& ui, const UiInput& input) {
  if (!simulated(ui, input) || ui.selection.body < 0) return false;
  const std::vector<SceneBody>& bodies = input.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(ui.selection.body);
  return body < bodies.size() && bodies[body].parent > 0;
}

void select_parent(UiState& ui, const UiInput& input) {
  const SimScene& scene = *input.frame->scene;
  const int parent = scene.controls.bodies[static_cast<std::size_t>(ui.selection.body)].parent;
  deselect_body(ui);
  ui.selection.body = parent;
  const auto geom =
      std::find_if(scene.geoms.begin(), scene.geoms.end(), [&](const SceneGeom& g) { return g.body_index == parent; });
  const Pose* X_WB = body_pose(input, parent);
  if (geom == scene.geoms.end() || X_WB == nullptr) return;
  ui.perturb.geom = static_cast<int>(geom - scene.geoms.begin());
  ui.perturb.point_G = input.frame->geom_poses[static_cast<std::size_t>(ui.perturb.geom)].inverse() * X_WB->p;
  ui.controls.geoms = {geom->name};
}

}  // namespace taxel::ui
