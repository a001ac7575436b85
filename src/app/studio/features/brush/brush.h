// The brush: paints the region of the skin that senses: samples lie there, and generators fill it. The region names
// faces of the mesh as loaded, the brush works on the skin.
#pragma once

#include "app/studio/app/pointing/surface_place.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/taxel/tool_state.h"
#include "core/mesh/surface_brush.h"

namespace taxel::ui {

/// Radius of the brush [m]: what was chosen, or a part of the mesh.
[[nodiscard]] double brush_radius(const ToolState& tool, const SensorModel& model);
/// Refuses what is not greater than 0 and finite; larger than the mesh counts as large as it.
void set_brush_radius(ToolState& tool, const SensorModel& model, double radius);
void resize_brush(ToolState& tool, const SensorModel& model, double notches);  ///< by 10 % a notch

/// Paints while the left button is down that went down on the skin; Shift or Ctrl held then: erases. A stroke is one
/// step of the history. True: the mouse is the brush's. x, y: pointer in pixels of the view.
bool brush_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y,
                 bool hovered);

/// Where the brush would paint: under the pointer, or none.
[[nodiscard]] std::optional<SurfacePlace> brush_place(const Viewer& viewer, const Shown& shown, double x, double y);

enum class RegionChange {
  clear,   ///< nothing is painted: then all of the skin counts
  invert,  ///< painted is what was not
  all
};
void change_region(WindowUi& ui, const Viewer& viewer, const Shown& shown, RegionChange change);

/// Faces of the skin -> faces of the mesh, and back; ascending. What is not on the skin has none there.
[[nodiscard]] std::vector<int> mesh_faces(const SensorModel& model, const std::vector<int>& skin_faces);
[[nodiscard]] std::vector<int> skin_faces(const SensorModel& model, const std::vector<int>& mesh_faces);

}  // namespace taxel::ui
