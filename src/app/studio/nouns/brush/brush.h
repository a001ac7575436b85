// The brush paints the sensing region of the skin. Samples are placed in the region, and generators fill the region.
// The region lists faces of the mesh as loaded, whereas the brush works on the skin.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/mesh/surface_brush.h"

namespace taxel::ui {

/// Returns the radius of the brush [m]: the chosen radius, or a fraction of the mesh's size if no radius was chosen.
[[nodiscard]] double brush_radius(const ToolState& tool, const SensorModel& model);
/// Sets the radius [m]. Refuses a radius that is not finite and greater than 0, and limits it to the size of the mesh.
void set_brush_radius(ToolState& tool, const SensorModel& model, double radius);
void resize_brush(ToolState& tool, const SensorModel& model, double notches);  ///< changes the radius by 10 % per notch

/// Paints while the left button is held after a press on the skin. Erases if Shift or Ctrl was held at that press. A
/// stroke is one step of the history. `x` and `y` are the pointer in pixels of the view. Returns whether the brush uses
/// the mouse.
bool brush_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y,
                 bool hovered);

/// Returns the place under the pointer where the brush would paint, or nothing if the pointer is off the skin.
[[nodiscard]] std::optional<SurfacePlace> brush_place(const Viewer& viewer, const Shown& shown, double x, double y);

enum class RegionChange {
  clear,   ///< paints no face, so that the whole skin senses
  invert,  ///< paints exactly the faces that were not painted
  all
};
void change_region(WindowUi& ui, const Viewer& viewer, const Shown& shown, RegionChange change);

/// Converts faces of the skin to faces of the mesh, and back, in ascending order. Faces of the mesh that are not on the
/// skin are left out.
[[nodiscard]] std::vector<int> mesh_faces(const SensorModel& model, const std::vector<int>& skin_faces);
[[nodiscard]] std::vector<int> skin_faces(const SensorModel& model, const std::vector<int>& mesh_faces);

/// Draws the outline of the brush on the skin under the pointer.
void draw_brush_ring(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool);

/// The popup next to the view's heading while the brush is active: the radius, the painted region and its commands.
extern const Feature kBrush;

}  // namespace taxel::ui
