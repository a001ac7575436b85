#include "app/studio/features/camera/frame_tool.h"

#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/taxel/gesture.h"
#include "core/layout/frame_guess.h"

namespace taxel::ui {

std::vector<FrameArrow> frame_arrows(const UiState& ui, const UiInput& input) {
  const bool shown = ui.mesh.frame_is_guess || ui.mesh.pick != FramePick::none;
  if (!shown || ui.mode != Mode::layout || !input.editing.project || !input.model) return {};
  constexpr double kBeyond = 1.3;  // of the way from the middle to the box
  const Aabb box = input.model->mesh->bounds();
  const Pose X_WM = shown_pose(ui, input);
  const SensorFrame& frame = input.editing.project->layout.frame;
  const auto arrow = [&](const char* name, const dvec3& direction) {
    const double reach = 0.5 * glm::dot(glm::abs(direction), box.extent());
    return FrameArrow{name, X_WM * box.center(), X_WM * (box.center() + kBeyond * reach * direction)};
  };
  return {arrow("tip", frame.distal), arrow("pad", frame.pad)};
}

void set_frame(UiState& ui, const SensorFrame& frame) {
  ui.mesh.frame_is_guess = false;
  ui.mesh.pick = FramePick::none;
  ui.ask(EditProject{SetFrame{frame}, {}});
}

SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction) {
  const SensorFrame before = frame;
  dvec3& set = what == FramePick::tip ? frame.distal : frame.pad;
  dvec3& other = what == FramePick::tip ? frame.pad : frame.distal;
  set = snapped_to_axis(direction);
  // One that would lie along the other is exchanged with it.
  if (std::abs(glm::dot(set, other)) > 0.9) other = what == FramePick::tip ? before.distal : before.pad;
  other = glm::normalize(other - glm::dot(other, set) * set);
  return frame;
}

bool pick_frame(UiState& ui, const UiInput& input, double x, double y) {
  if (ui.mesh.pick == FramePick::none || ui.mode != Mode::layout) return false;
  const std::optional<PlacementGhost> under = placement_ghost(ui, input, x, y);
  if (!under) return true;
  set_frame(ui, with_direction(input.editing.project->layout.frame, ui.mesh.pick, under->taxel.normal));
  return true;
}

}  // namespace taxel::ui
