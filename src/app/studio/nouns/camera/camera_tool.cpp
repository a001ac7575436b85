// The commands about cameras, the camera that follows the scene, and tests of whether the view shows the sensors.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "ui/scene/camera.h"

namespace taxel::ui {
namespace {

constexpr double kAzimuthDeg = -108, kElevationDeg = 15, kLayoutAzimuthDeg = -60;
/// Factor on the camera's distance in a sweep. The box around a whole path is larger than the visible objects at any
/// one time, so the camera moves closer.
constexpr double kSweepCloseness = 0.7;
/// Largest number of wheel notches by which the camera moves back: 170 times as far.
constexpr int kMaxStepsBack = 40;
/// Distance of MuJoCo's free camera from the centre, in extents of the model.
constexpr double kExtents = 1.5;
/// Smallest assumed distance from a camera of the scene to the middle of the scene, in sizes of the scene.
constexpr double kLeastDepth = 1e-3;

double half_tangent(double degrees) {
  return std::tan(0.5 * glm::radians(degrees));
}

bool simulated(const Viewer& viewer, const RunView& run) {
  return shows_run(viewer.mode) && run.frame && run.frame->scene;
}

const Pose* camera_pose(const Viewer& viewer, const RunView& run, const FollowState& follow) {
  const auto camera = static_cast<std::size_t>(follow.camera);
  const bool has_camera =
      simulated(viewer, run) && follow.camera >= 0 &&
      camera < std::min(run.frame->scene->marks.cameras.size(), run.frame->mark_poses.cameras.size());
  return has_camera ? &run.frame->mark_poses.cameras[camera] : nullptr;
}

const Pose* body_pose(const RunView& run, int body) {
  const auto b = static_cast<std::size_t>(body);
  return body >= 0 && b < run.frame->mark_poses.bodies.size() ? &run.frame->mark_poses.bodies[b] : nullptr;
}

Aabb sensors_box(const Viewer& viewer, const Shown& shown) {
  Aabb box;
  for (const BoxCorners& corners : sensor_boxes(viewer, shown))
    for (const dvec3& p_W : corners) box.include(p_W);
  return box;
}

double depth_of_scene(const Viewer& viewer, const Shown& shown, const Pose& X_WC) {
  const Aabb box = scene_box(viewer, shown);
  if (box.empty()) return 1;
  const dvec3 way = box.center() - X_WC.p;
  const double ahead = -glm::dot(way, X_WC.rotation()[2]);
  return std::max(ahead > 0 ? ahead : glm::length(way), kLeastDepth * box.diagonal());
}

/// Returns whether the file of the scene sets the direction, the centre or the size of its first view.
bool sets_own_view(const SimScene& scene) {
  return scene.look && scene.look->has_own_view;
}

/// Sets the view of MuJoCo's free camera.
void take_own_view(Camera& camera, const SceneOverview& overview) {
  if (!(overview.extent > 0)) return;
  camera.target = overview.center_W;
  camera.azimuth_deg = std::remainder(overview.azimuth_deg, 360.0);
  camera.elevation_deg = overview.elevation_deg;
  camera.distance = kExtents * overview.extent * half_tangent(overview.fov_deg) / half_tangent(camera.fov_deg);
}

}  // namespace

bool has_several_sensors(const Viewer& viewer, const Shown& shown) {
  if (!shown.shows_scene(viewer) || !shown.run.frame || !shown.run.frame->scene || shown.run.runs_scenario)
    return false;
  const std::vector<SensorModelPtr>& sensors = shown.run.frame->scene->sensors;
  return std::count_if(sensors.begin(), sensors.end(),
                       [](const SensorModelPtr& model) { return model && model->taxel_count() > 0; }) > 1;
}

Camera first_camera(Mode mode) {
  Camera camera;
  camera.azimuth_deg = mode == Mode::layout ? kLayoutAzimuthDeg : kAzimuthDeg;
  camera.elevation_deg = kElevationDeg;
  return camera;
}

void show_scene_first(Viewer& viewer, const Shown& shown, bool turns) {
  if (turns) look_at_touching_side(viewer, shown);
  frame_scene(viewer, shown);
  if (simulated(viewer, shown.run) && shown.document.is_scene && sets_own_view(*shown.run.frame->scene))
    take_own_view(viewer.camera(), shown.run.frame->scene->marks.overview);
}

void frame_scene(Viewer& viewer, const Shown& shown) {
  Camera& camera = viewer.camera();
  camera.frame(has_several_sensors(viewer, shown) ? sensors_box(viewer, shown) : scene_box(viewer, shown));
  if (shows_run(viewer.mode) && shown.run.runs_scenario) camera.distance *= kSweepCloseness;
  if (viewer.view.width <= 0 || viewer.view.height <= 0) return;
  // A narrow view, or a sensor far from the middle of its path: the camera moves back until all of it is shown.
  const std::vector<BoxCorners> sensors = sensor_boxes(viewer, shown);
  const auto shows_all = [&] {
    return std::all_of(sensors.begin(), sensors.end(), [&](const BoxCorners& box) {
      return is_inside_view(box, camera, viewer.view.width, viewer.view.height);
    });
  };
  for (int i = 0; i < kMaxStepsBack && !shows_all(); ++i) camera.zoom(-1);
}

void align_camera(Viewer& viewer, const Shown& shown, FollowState& follow) {
  free_camera(viewer, follow);
  Camera& camera = viewer.camera();
  camera = first_camera(viewer.mode);
  look_at_touching_side(viewer, shown);
  frame_scene(viewer, shown);
  if (!simulated(viewer, shown.run) || !shown.document.is_scene) return;
  take_own_view(camera, shown.run.frame->scene->marks.overview);
}

bool looks_through_camera(const Viewer& viewer, const FollowState& follow) {
  return shows_run(viewer.mode) && follow.camera >= 0;
}

bool has_cameras(const Viewer& viewer, const RunView& run) {
  return simulated(viewer, run) && !run.frame->mark_poses.cameras.empty();
}

void look_through_next(const Viewer& viewer, const Shown& shown, FollowState& follow, int direction) {
  const int count = static_cast<int>(shown.run.frame->mark_poses.cameras.size());
  look_through(viewer, shown, follow,
               follow.camera < 0 ? (direction > 0 ? 0 : count - 1) : (follow.camera + direction + count) % count);
}

void look_through(const Viewer& viewer, const Shown& shown, FollowState& follow, int camera) {
  if (follow.camera < 0) follow.free = viewer.camera();
  follow.body = -1;
  follow.camera = camera;
  if (const Pose* X_WC = camera_pose(viewer, shown.run, follow)) follow.depth = depth_of_scene(viewer, shown, *X_WC);
}

void track_body(Viewer& viewer, const RunView& run, FollowState& follow, const Pick& under) {
  free_camera(viewer, follow);
  viewer.camera().target = under.position_W;
  const int geom = picked_geom(*run.frame->scene, under);
  if (geom < 0) return;
  const int body = run.frame->scene->geoms[static_cast<std::size_t>(geom)].body_index;
  const Pose* X_WB = body_pose(run, body);
  if (body == 0 || X_WB == nullptr) return;
  follow.body = body;
  follow.point_B = X_WB->inverse() * under.position_W;
  follow.point_W = under.position_W;
}

void leave_followed(Viewer& viewer, FollowState& follow) {
  if (follow.camera >= 0) viewer.cameras[1] = follow.free;
  follow = {};
}

void free_camera(Viewer& viewer, FollowState& follow) {
  if (shows_run(viewer.mode)) leave_followed(viewer, follow);
}

std::string follow_text(const Viewer& viewer, const RunView& run, const FollowState& follow) {
  if (!simulated(viewer, run)) return {};
  const SimScene& scene = *run.frame->scene;
  const auto camera = static_cast<std::size_t>(follow.camera), body = static_cast<std::size_t>(follow.body);
  if (follow.camera >= 0 && camera < scene.marks.cameras.size())
    return "Camera " + scene.marks.cameras[camera].name + "   [ ] others, Esc frees";
  if (follow.body >= 0 && body < scene.controls.bodies.size())
    return "Tracks " + scene.controls.bodies[body].name + "   Esc frees";
  return {};
}

bool can_select_parent(const Viewer& viewer, const RunView& run) {
  if (!simulated(viewer, run) || viewer.selection.body < 0) return false;
  const std::vector<SceneBody>& bodies = run.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(viewer.selection.body);
  return body < bodies.size() && bodies[body].parent > 0;
}

void select_parent(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb,
                   ControlsState& controls) {
  const SimScene& scene = *run.frame->scene;
  const int parent = scene.controls.bodies[static_cast<std::size_t>(selection.body)].parent;
  deselect_body(ui, selection, perturb);
  selection.body = parent;
  const auto geom =
      std::find_if(scene.geoms.begin(), scene.geoms.end(), [&](const SceneGeom& g) { return g.body_index == parent; });
  const Pose* X_WB = body_pose(run, parent);
  if (geom == scene.geoms.end() || X_WB == nullptr) return;
  perturb.geom = static_cast<int>(geom - scene.geoms.begin());
  perturb.point_G = run.frame->geom_poses[static_cast<std::size_t>(perturb.geom)].inverse() * X_WB->p;
  controls.geoms = {geom->name};
}

void follow_scene(Viewer& viewer, const RunView& run, FollowState& follow) {
  if (!simulated(viewer, run) || (follow.camera < 0 && follow.body < 0)) return;
  if (follow.camera >= 0) {
    const Pose* X_WC = camera_pose(viewer, run, follow);
    if (X_WC == nullptr) return leave_followed(viewer, follow);  // another scene
    const SceneCamera& from = run.frame->scene->marks.cameras[static_cast<std::size_t>(follow.camera)];
    viewer.camera().look_from(*X_WC, follow.depth);
    viewer.camera().orthographic = from.orthographic;
    viewer.camera().fov_deg =
        from.orthographic ? glm::degrees(2 * std::atan(0.5 * from.height / follow.depth)) : from.height;
  } else if (const Pose* X_WB = body_pose(run, follow.body)) {
    const dvec3 now = *X_WB * follow.point_B;
    viewer.camera().target += now - follow.point_W;
    follow.point_W = now;
  }
}

namespace {

void drag_camera(App& app, const PointerEvent& event) {
  if (looks_through_camera(*app.viewer, app.get<FollowState>())) return;
  Camera& camera = app.viewer->camera();
  if (event.left().dragged()) camera.orbit(event.delta.x, event.delta.y);
  if (event.right().dragged()) camera.pan(event.delta.x, event.delta.y, app.viewer->view.height, event.shift);
  if (event.middle().dragged()) camera.zoom(-0.05 * event.delta.y);
}

bool point_camera(App& app, const PointerEvent& event) {
  if (event.grabbed) drag_camera(app, event);
  return !event.hovered;
}

}  // namespace

constinit const Feature kCameraFollow{
    .update =
        [](App& app) {
          follow_scene(*app.viewer, app.shown->run, app.get<FollowState>());
          lead_to_contact(app, ImGui::GetIO().DeltaTime);
        },
    .tool = {"camera", kEverywhere, point_camera, 13, [](const App&) { return true; },
             [](App& app) { free_camera(*app.viewer, app.get<FollowState>()); }},
    .dump = dump_camera_follow,
};

namespace {

/// A scene that runs or a recorded step; in LAYOUT a mesh, or the scene whose layouts can be edited.
bool has_scene(const App& app) {
  if (app.shown->shows_scene(*app.viewer) && !(app.shown->run.frame && app.shown->run.frame->scene)) return false;
  return !scene_box(*app.viewer, *app.shown).empty();
}

}  // namespace

void carry_out(const FrameCamera& command, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  app.viewer->camera().frame(command.selection ? selection_box(*app.viewer, *app.shown)
                                               : scene_box(*app.viewer, *app.shown));
}

void carry_out(const AlignCamera&, App& app) {
  align_camera(*app.viewer, *app.shown, app.get<FollowState>());
}

void carry_out(const TakeStandardView& command, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  take_standard_view(app.viewer->camera(), command.axis);
}

void carry_out(const ToggleOrthographic&, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  app.viewer->camera().orthographic = !app.viewer->camera().orthographic;
}

void carry_out(const StepCamera& command, App& app) {
  look_through_next(*app.viewer, *app.shown, app.get<FollowState>(), command.direction);
}

void carry_out(const LookThroughCamera& command, App& app) {
  if (command.camera < 0) return leave_followed(*app.viewer, app.get<FollowState>());
  if (has_cameras(*app.viewer, app.shown->run) &&
      command.camera < static_cast<int>(app.shown->run.frame->mark_poses.cameras.size()))
    look_through(*app.viewer, *app.shown, app.get<FollowState>(), command.camera);
}

void frame_cameras(App& app) {
  const Mode mode = app.viewer->mode;
  for (const Mode each : {Mode::layout, Mode::simulate}) {
    const std::size_t i = each == Mode::layout ? 0 : 1;
    app.viewer->mode = each;
    if (!app.get<Framing>().turns[i] || !has_scene(app)) continue;
    app.get<Framing>().turns[i] = false;
    const bool is_first = std::exchange(app.get<Framing>().first[i], false);
    const std::optional<Camera> saved = std::exchange(app.get<Framing>().saved[i], std::nullopt);
    show_scene_first(*app.viewer, *app.shown, is_first);
    app.get<Framing>().framed[i] = app.viewer->cameras[i];
    if (saved) app.viewer->cameras[i] = *saved;
    if (each == Mode::simulate && is_first) app.get<ContactCamera>().leads = !saved;
  }
  app.viewer->mode = mode;
  if (!app.get<Framing>().checks_view || !has_scene(app)) return;
  app.get<Framing>().checks_view = false;
  const bool follows = looks_through_camera(*app.viewer, app.get<FollowState>()) || app.get<FollowState>().body >= 0;
  if (follows || !sensors_are_outside_view(*app.viewer, *app.shown)) return;
  frame_scene(*app.viewer, *app.shown);
  app.get<Framing>().framed[mode == Mode::layout ? 0 : 1] = app.viewer->camera();
}

bool has_untouched_camera(const App& app) {
  const std::optional<Camera>& framed = app.get<Framing>().framed[app.viewer->mode == Mode::layout ? 0 : 1];
  return framed == app.viewer->camera() && app.get<FollowState>().camera < 0 && app.get<FollowState>().body < 0;
}

BoxCorners corners_of(const Aabb& box_M, const Pose& X_WM) {
  BoxCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 p_M((i & 1U) != 0 ? box_M.hi.x : box_M.lo.x, (i & 2U) != 0 ? box_M.hi.y : box_M.lo.y,
                    (i & 4U) != 0 ? box_M.hi.z : box_M.lo.z);
    corners[i] = X_WM * p_M;
  }
  return corners;
}

std::vector<BoxCorners> sensor_boxes(const Viewer& viewer, const Shown& shown) {
  std::vector<BoxCorners> boxes;
  if (shown.shows_scene(viewer) && shown.run.frame && shown.run.frame->scene) {
    const auto& sensors = shown.run.frame->scene->sensors;
    for (std::size_t i = 0; i < sensors.size() && i < shown.run.frame->sensors.size(); ++i)
      boxes.push_back(corners_of(sensors[i]->mesh->bounds(), shown.run.frame->sensors[i].X_WM));
  } else if (shown.document.model && !shown.document.model->mesh->bounds().empty()) {
    boxes.push_back(corners_of(shown.document.model->mesh->bounds(), shown_pose(viewer, shown)));
  }
  return boxes;
}

bool is_inside_view(const BoxCorners& box_W, const Camera& camera, int width, int height) {
  return std::all_of(box_W.begin(), box_W.end(), [&](const dvec3& p_W) {
    const dvec3 pixel = camera.project(p_W, width, height);
    return pixel.z > camera.near_plane() && pixel.x >= 0 && pixel.y >= 0 && pixel.x <= width && pixel.y <= height;
  });
}

bool is_outside_view(const BoxCorners& box_W, const Camera& camera, int width, int height) {
  const glm::dmat4 view = camera.view();
  const double slope_y = std::tan(0.5 * glm::radians(camera.fov_deg)), slope_x = slope_y * width / height;
  // A corner is beyond a side if it is farther from the axis of the view than the side is at the corner's depth.
  std::array<bool, 5> beyond{true, true, true, true, true};  // left, right, bottom, top, behind
  for (const dvec3& p_W : box_W) {
    const dvec3 p_C(view * glm::dvec4(p_W, 1));
    const double depth = -p_C.z;
    const double scale = camera.depth_scale(depth);
    const std::array<bool, 5> here{p_C.x<-slope_x * scale, p_C.x> slope_x * scale,
                                   p_C.y<-slope_y * scale, p_C.y> slope_y * scale, depth < camera.near_plane()};
    for (std::size_t i = 0; i < beyond.size(); ++i) beyond[i] = beyond[i] && here[i];
  }
  return std::any_of(beyond.begin(), beyond.end(), [](bool all) { return all; });
}

bool sensors_are_outside_view(const Viewer& viewer, const Shown& shown) {
  if (viewer.view.width <= 0 || viewer.view.height <= 0) return false;
  const std::vector<BoxCorners> boxes = sensor_boxes(viewer, shown);
  return !boxes.empty() && std::all_of(boxes.begin(), boxes.end(), [&](const BoxCorners& box) {
    return is_outside_view(box, viewer.camera(), viewer.view.width, viewer.view.height);
  });
}

}  // namespace taxel::ui
