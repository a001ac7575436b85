#include "app/studio/features/perturb/perturb_tool.h"

#include <imgui.h>

#include <cmath>

namespace taxel::ui {

namespace {

/// Away from the eye along the ground; of a camera that looks straight down or up, where the top of its picture is.
dvec3 level_direction(const Camera& camera, const dvec3& forward) {
  constexpr double kStraight = 1e-6;
  const glm::dmat4 view = camera.view();
  dvec3 level(forward.x, forward.y, 0);
  if (glm::length(level) < kStraight) level = dvec3(view[0][1], view[1][1], 0);
  return glm::normalize(level);
}

bool can_hold(const UiState& ui, const UiInput& input) {
  if (ui.mode != Mode::simulate || !input.frame || input.frame->recorded || ui.selection.body < 0) return false;
  const auto geom = static_cast<std::size_t>(ui.perturb.geom);
  return ui.perturb.geom >= 0 && geom < input.frame->geom_poses.size() &&
         input.frame->scene->geoms[geom].body_index == ui.selection.body;
}

void ask_perturb(UiState& ui, Perturb perturb) {
  perturb.geom = ui.perturb.geom;
  perturb.point_G = ui.perturb.point_G;
  perturb.grip = ui.perturb.grip;
  ui.ask(SendCommand{EditSceneCommand{perturb}});
}

}  // namespace

int picked_geom(const SimScene& scene, const Pick& pick) {
  if (pick.geom >= 0) return pick.geom;
  for (std::size_t g = 0; g < scene.geoms.size(); ++g)
    if (pick.sensor >= 0 && scene.geoms[g].sensor == pick.sensor) return static_cast<int>(g);
  return -1;
}

void deselect_body(UiState& ui) {
  if (ui.perturb.kind != Perturb::Kind::none) ask_perturb(ui, {});
  ui.perturb.kind = Perturb::Kind::none;
  ui.perturb.geom = -1;
  ui.selection.body = -1;
}

void select_body(UiState& ui, const UiInput& input, const std::optional<Pick>& under) {
  deselect_body(ui);
  if (!under || !input.frame) return;
  const int geom = picked_geom(*input.frame->scene, *under);
  if (geom < 0) return;
  const auto g = static_cast<std::size_t>(geom);
  ui.controls.geoms = {input.frame->scene->geoms[g].name};
  if (input.frame->scene->geoms[g].body_index == 0) return;
  ui.selection.body = input.frame->scene->geoms[g].body_index;
  ui.perturb.geom = geom;
  ui.perturb.point_G = input.frame->geom_poses[g].inverse() * under->position_W;
}

Perturb dragged_body(const Camera& camera, int height, const dvec2& pixels, Perturb::Kind kind, bool level,
                     const dvec3& grabbed_W) {
  const dvec3 forward = glm::normalize(camera.target - camera.eye()), up(0, 0, 1);
  const dvec3 ahead = level_direction(camera, forward), right = glm::cross(ahead, up);
  Perturb perturb;
  perturb.kind = kind;
  if (kind == Perturb::Kind::pull) {
    const double depth = glm::dot(grabbed_W - camera.eye(), forward);
    const double metres = 2 * depth * std::tan(0.5 * glm::radians(camera.fov_deg)) / height;  // a pixel's, there
    perturb.moved_W = metres * (pixels.x * right - pixels.y * (level ? ahead : up));
  } else {
    const dvec3 axis = pixels.x * (level ? ahead : up) + pixels.y * right;
    const double length = glm::length(axis);
    if (length > 0) perturb.turned_W = glm::angleAxis(2 * kPi * length / height, axis / length);
  }
  return perturb;
}

bool handle_perturb_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  PerturbState& state = ui.perturb;
  const bool holds = state.kind != Perturb::Kind::none;
  if (holds && can_hold(ui, input) && ImGui::IsMouseDown(state.button)) {
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) {
      Perturb perturb = dragged_body(ui.camera(), ui.view.height, dvec2(x, y) - state.start, state.kind, io.KeyShift,
                                     state.grabbed_W);
      perturb.running = input.playing;
      ask_perturb(ui, perturb);
    }
    return true;
  }
  if (holds) {
    ask_perturb(ui, {});
    state.kind = Perturb::Kind::none;
    return true;
  }
  const bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left), right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (!hovered || !io.KeyCtrl || !(left || right) || !can_hold(ui, input)) return false;
  state.kind = left && !io.KeyAlt ? Perturb::Kind::turn : Perturb::Kind::pull;
  state.button = left ? ImGuiMouseButton_Left : ImGuiMouseButton_Right;
  ++state.grip;
  state.start = {x, y};
  state.grabbed_W = input.frame->geom_poses[static_cast<std::size_t>(state.geom)] * state.point_G;
  Perturb perturb;
  perturb.kind = state.kind;
  perturb.running = input.playing;
  ask_perturb(ui, perturb);
  return true;
}

}  // namespace taxel::ui
