#include "app/studio/features/camera/frame_tool.h"

#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/taxel/gesture.h"
#include "core/layout/frame_guess.h"

namespace taxel::ui {

std::vector<FrameArrow> frame_arrows(const Viewer& viewer, const Shown& displayed, const MeshState& mesh) {
  const bool shown = mesh.frame_is_guess || mesh.pick != FramePick::none;
  if (!shown || viewer.mode != Mode::layout || !displayed.document.editing.project || !displayed.document.model)
    return {};
  constexpr double kBeyond = 1.3;  // arrow length as a fraction of the distance from the middle to the box
  const Aabb box = displayed.document.model->mesh->bounds();
  const Pose X_WM = shown_pose(viewer, displayed);
  const SensorFrame& frame = displayed.document.editing.project->layout.frame;
  const auto arrow = [&](const char* name, const dvec3& direction) {
    const double reach = 0.5 * glm::dot(glm::abs(direction), box.extent());
    return FrameArrow{name, X_WM * box.center(), X_WM * (box.center() + kBeyond * reach * direction)};
  };
  return {arrow("tip", frame.distal), arrow("pad", frame.pad)};
}

void set_frame(WindowUi& ui, MeshState& mesh, const SensorFrame& frame) {
  mesh.frame_is_guess = false;
  mesh.pick = FramePick::none;
  ui.post(EditProject{SetFrame{frame}, {}});
}

SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction) {
  const SensorFrame before = frame;
  dvec3& set = what == FramePick::tip ? frame.distal : frame.pad;
  dvec3& other = what == FramePick::tip ? frame.pad : frame.distal;
  set = snapped_to_axis(direction);
  // If the new direction is nearly parallel to the other one, the two directions are exchanged.
  if (std::abs(glm::dot(set, other)) > 0.9) other = what == FramePick::tip ? before.distal : before.pad;
  other = glm::normalize(other - glm::dot(other, set) * set);
  return frame;
}

bool pick_frame(WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, MeshState& mesh,
                double x, double y) {
  if (mesh.pick == FramePick::none || viewer.mode != Mode::layout) return false;
  const std::optional<PlacementGhost> under = placement_ghost(viewer, shown, tool, x, y);
  if (!under) return true;
  set_frame(ui, mesh, with_direction(shown.document.editing.project->layout.frame, mesh.pick, under->taxel.normal));
  return true;
}

}  // namespace taxel::ui
