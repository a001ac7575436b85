// Selecting and dragging a body with the controls of MuJoCo's viewer.
#include "app/studio/nouns/perturb/perturb_state.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/run/host_event.h"

namespace taxel::ui {

namespace {

/// Returns the direction away from the eye along the ground. For a camera that looks straight down or up, returns the
/// direction of the upper edge of the image.
dvec3 level_direction(const Camera& camera, const dvec3& forward) {
  constexpr double kStraight = 1e-6;
  const glm::dmat4 view = camera.view();
  dvec3 level(forward.x, forward.y, 0);
  if (glm::length(level) < kStraight) level = dvec3(view[0][1], view[1][1], 0);
  return glm::normalize(level);
}

bool can_hold(const Viewer& viewer, const RunView& run, const PerturbState& perturb) {
  if (!shows_run(viewer.mode) || !run.frame || run.frame->recorded || viewer.selection.body < 0) return false;
  const auto geom = static_cast<std::size_t>(perturb.geom);
  return perturb.geom >= 0 && geom < run.frame->geom_poses.size() &&
         run.frame->scene->geoms[geom].body_index == viewer.selection.body;
}

void ask_perturb(WindowUi& ui, const PerturbState& state, Perturb perturb) {
  perturb.geom = state.geom;
  perturb.point_G = state.point_G;
  perturb.grip = state.grip;
  ui.post(EditSceneCommand{perturb});
}

}  // namespace

int picked_geom(const SimScene& scene, const Pick& pick) {
  if (pick.geom >= 0) return pick.geom;
  for (std::size_t g = 0; g < scene.geoms.size(); ++g)
    if (pick.sensor >= 0 && scene.geoms[g].sensor == pick.sensor) return static_cast<int>(g);
  return -1;
}

void deselect_body(WindowUi& ui, Selection& selection, PerturbState& perturb) {
  if (perturb.kind != Perturb::Kind::none) ask_perturb(ui, perturb, {});
  perturb.kind = Perturb::Kind::none;
  perturb.geom = -1;
  selection.body = -1;
}

void select_body(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb, ControlsState& controls,
                 const std::optional<Pick>& under) {
  deselect_body(ui, selection, perturb);
  if (!under || !run.frame) return;
  const int geom = picked_geom(*run.frame->scene, *under);
  if (geom < 0) return;
  const auto g = static_cast<std::size_t>(geom);
  controls.geoms = {run.frame->scene->geoms[g].name};
  if (run.frame->scene->geoms[g].body_index == 0) return;
  selection.body = run.frame->scene->geoms[g].body_index;
  perturb.geom = geom;
  perturb.point_G = run.frame->geom_poses[g].inverse() * under->position_W;
}

Perturb dragged_body(const Camera& camera, int height, const dvec2& pixels, Perturb::Kind kind, bool level,
                     const dvec3& grabbed_W) {
  const dvec3 forward = glm::normalize(camera.target - camera.eye()), up(0, 0, 1);
  const dvec3 ahead = level_direction(camera, forward), right = glm::cross(ahead, up);
  Perturb perturb;
  perturb.kind = kind;
  if (kind == Perturb::Kind::pull) {
    const double depth = glm::dot(grabbed_W - camera.eye(), forward);
    const double metres = camera.pixel_size(depth, height);
    perturb.moved_W = metres * (pixels.x * right - pixels.y * (level ? ahead : up));
  } else {
    const dvec3 axis = pixels.x * (level ? ahead : up) + pixels.y * right;
    const double length = glm::length(axis);
    if (length > 0) perturb.turned_W = glm::angleAxis(2 * kPi * length / height, axis / length);
  }
  return perturb;
}

bool handle_perturb_mouse(WindowUi& ui, const Viewer& viewer, const RunView& run, PerturbState& state,
                          const PointerEvent& event) {
  const bool holds = state.kind != Perturb::Kind::none;
  if (holds && can_hold(viewer, run, state) && event.buttons.at(static_cast<std::size_t>(state.button)).down) {
    if (event.delta != dvec2(0)) {
      Perturb perturb = dragged_body(viewer.camera(), viewer.view.height, event.at - state.start, state.kind,
                                     event.shift, state.grabbed_W);
      perturb.running = run.playing;
      ask_perturb(ui, state, perturb);
    }
    return true;
  }
  if (holds) {
    ask_perturb(ui, state, {});
    state.kind = Perturb::Kind::none;
    return true;
  }
  const bool left = event.left().pressed, right = event.right().pressed;
  if (!event.hovered || !event.ctrl || !(left || right) || !can_hold(viewer, run, state)) return false;
  state.kind = left && !event.alt ? Perturb::Kind::turn : Perturb::Kind::pull;
  state.button = left ? 0 : 1;
  ++state.grip;
  state.start = event.at;
  state.grabbed_W = run.frame->geom_poses[static_cast<std::size_t>(state.geom)] * state.point_G;
  Perturb perturb;
  perturb.kind = state.kind;
  perturb.running = run.playing;
  ask_perturb(ui, state, perturb);
  return true;
}

namespace {

/// A double click with the right button centres the camera instead.
bool point_body(App& app, const PointerEvent& event) {
  const bool centres = event.hovered && event.right().double_pressed;
  return !centres && handle_perturb_mouse(*app.ui, *app.viewer, app.shown->run, app.get<PerturbState>(), event);
}

}  // namespace

constinit const Feature kPerturb{
    .tool = {"perturb", kEverywhere, point_body},
};

}  // namespace taxel::ui
