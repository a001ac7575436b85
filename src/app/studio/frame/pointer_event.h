// The pointer over the 3-D view in one frame, read from Dear ImGui in one place, and places on the skin below it.
#pragma once

#include <array>
#include <optional>

#include "app/studio/frame/viewer.h"
#include "core/base/math.h"
#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

/// One mouse button in one frame.
struct ButtonState {
  bool down = false;
  bool pressed = false;         ///< went down in this frame
  bool double_pressed = false;  ///< went down in this frame, shortly after an earlier press
  bool released = false;        ///< went up in this frame
  bool moved = false;           ///< has left the place where it went down, by more than a click tolerates

  [[nodiscard]] bool dragged() const { return down && moved; }
  /// Returns whether the button was pressed and released at the same place.
  [[nodiscard]] bool clicked() const { return released && !moved; }
};

struct PointerEvent {
  dvec2 at{0};            ///< position [pixels of the view]
  dvec2 delta{0};         ///< motion since the previous frame [pixels]
  double wheel = 0;       ///< notches of the wheel
  bool hovered = false;   ///< whether the pointer is over the view
  bool grabbed = false;   ///< whether a button went down over the view and is still down
  bool any_down = false;  ///< whether any button is down
  bool ctrl = false, shift = false, alt = false;
  std::array<ButtonState, 3> buttons;  ///< left, right, middle

  [[nodiscard]] const ButtonState& left() const { return buttons[0]; }
  [[nodiscard]] const ButtonState& right() const { return buttons[1]; }
  [[nodiscard]] const ButtonState& middle() const { return buttons[2]; }
};

/// Reads the pointer over the view's item, which is the last one that was laid out.
[[nodiscard]] PointerEvent read_pointer(const ViewPlace& place);

/// Returns whether the pointer rests over the view's item long enough for a tooltip, with no button down.
[[nodiscard]] bool is_pointer_resting();

// Places on the skin, all in the frame M of the mesh file.

struct SurfacePlace {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};  ///< outward normal of the face
  int face = -1;
};

/// Returns where a ray first meets a face that looks towards the ray's origin, or, with `away`, one that looks away.
std::optional<SurfacePlace> place_under(const MeshIndex& skin, const Ray& ray_M, bool away = false);

/// Returns the place nearest to a point.
SurfacePlace place_near(const MeshIndex& skin, const dvec3& p_M);

/// Returns the corner of the place's face that is nearest to the place.
SurfacePlace nearest_corner(const MeshIndex& skin, const SurfacePlace& place);

/// Returns a direction turned by the shortest rotation from `from` to `to`; unit vectors.
dvec3 turned_with(const dvec3& direction, const dvec3& from, const dvec3& to);

/// Returns a direction turned about an axis (unit vector), by the right-hand rule.
dvec3 turned_about(const dvec3& direction, const dvec3& axis, double radians);

/// Returns how far along a line (unit direction) the point nearest to a ray is; 0 if they are parallel.
double along_line(const dvec3& origin, const dvec3& direction, const Ray& ray);

}  // namespace taxel::ui
