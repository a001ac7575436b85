// The scene of the 3-D view, its extent and the pose of the edited sensor in it, drawing over it, and the table of the
// overlays that can be turned on and off.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>

#include "app/studio/frame/keymap.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/base/math.h"
#include "core/hydro/traction.h"
#include "core/run/frame.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct App;

/// Returns the box that the camera can frame: sensor and path in SIMULATE, mesh in LAYOUT. Empty if there is nothing.
[[nodiscard]] Aabb scene_box(const Viewer& viewer, const Shown& shown);
/// Returns the box of the contact surfaces of a sensor in the displayed step, or of all sensors if `sensor` is -1, or
/// of the pressed probe, with a little room around them; empty without contact.
[[nodiscard]] Aabb contact_box(const Viewer& viewer, const Shown& shown, int sensor = -1);
/// Returns the box of the selected taxels' receptive fields. If none is selected, returns the contact of the sensor
/// that the user chose, or of all sensors; without contact the box of that sensor or of all in SIMULATE, and an empty
/// box in LAYOUT.
[[nodiscard]] Aabb selection_box(const Viewer& viewer, const Shown& shown);
/// Returns the pose of the mesh file's frame in the world, as the view shows it.
[[nodiscard]] Pose shown_pose(const Viewer& viewer, const Shown& shown);

/// Returns the scene around the edited layout of a scene, or nothing if no such layout is displayed.
[[nodiscard]] std::optional<Surroundings> surroundings(const Viewer& viewer, const Shown& shown);

/// Returns the scene that the 3-D view and the section draw.
[[nodiscard]] SceneInput scene_input(const App& app);

/// Adds a clip plane through the middle, across the line of sight, or removes it.
void toggle_clip(Viewer& viewer, const Shown& shown);

/// Returns the centre of pressure of all sensors of a frame [m], world, which cameras follow. Empty without contact.
[[nodiscard]] inline std::optional<dvec3> contact_center(const SimFrame& frame) {
  CenterOfPressure center_W;
  for (const SensorStep& sensor : frame.sensors)
    for (const ContactSurface& surface : sensor.surfaces) center_W.add(surface, sensor.X_WM);
  return center_W.value();
}

// Pixels of points, and lines of text below the heading of the view.

/// Returns the pixel of the window at which a point of the scene is displayed.
[[nodiscard]] ImVec2 on_screen(const Viewer& viewer, const dvec3& p_W);
/// Draws the name of a standard or orthographic view, such as "Front, orthographic", in a row of texts of the view.
/// Returns the next free row.
int draw_view_name(const WindowUi& ui, const Viewer& viewer, ImDrawList& list, int row);
/// Draws a line of text below the heading of the view. Lines are numbered downward.
void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color);
/// Returns the upper edge of the line with this number [pixels of the window].
[[nodiscard]] float view_line_top(const ViewPlace& place, int row);

/// One overlay: its key in the settings file, its menu entry and its value. Its default is the member's own.
struct OverlaySpec {
  const char* key;
  const char* menu;  ///< "View" or a submenu of it; overlays of one menu follow each other
  const char* label;
  bool Overlays::*on;
  int chord = 0;
  Context context = Context::everywhere;
};
/// All overlays; the View menu lists them in this order.
std::span<const OverlaySpec> overlays();

}  // namespace taxel::ui
