// The XYZ gizmo in the lower left corner of the 3-D view. It shows the directions of the axes; a click on an axis looks
// along it.
#pragma once

#include <array>

#include "ui/scene/pick/camera.h"

namespace taxel::ui {

/// One ball of the gizmo: the end of +x, -x, +y, -y, +z or -z.
struct GizmoBall {
  int axis = 0;       ///< 0..5 in this order
  dvec2 pixel{0};     ///< centre of the ball, from the upper left corner of the view
  double toward = 0;  ///< from -1 (away from the eye) to +1 (towards the eye)
  [[nodiscard]] bool positive() const { return axis % 2 == 0; }
};

inline constexpr double kGizmoReach = 34;      ///< distance of the balls from the middle [pixel]
inline constexpr double kGizmoBallRadius = 9;  ///< radius of a ball [pixel]
inline constexpr double kGizmoMargin = 16;     ///< distance from the edges of the view [pixel]

/// Returns the middle of the gizmo in a view of this size. All pixels are those of scale 1.
dvec2 gizmo_center(const dvec2& view);
/// Returns all six balls, farthest first, which is the order of drawing.
std::array<GizmoBall, 6> gizmo_balls(const Camera& camera, const dvec2& view);

/// Returns the axis 0..5 whose ball is under a pixel, or -1. If balls overlap, the nearest to the eye has priority.
int gizmo_hit(const Camera& camera, const dvec2& at, const dvec2& view);
/// Turns the camera to look from the end of an axis. Target and distance do not change.
void look_from_axis(Camera& camera, int axis);
/// Turns the camera to one of the standard views, as Blender has them: from the end of an axis exactly, upright, with x
/// to the right from above and below. Target and distance do not change.
void take_standard_view(Camera& camera, int axis);
/// Returns the name of the standard view that a camera has, such as "Front", or an empty name.
const char* standard_view_name(const Camera& camera);

}  // namespace taxel::ui
