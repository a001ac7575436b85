// The XYZ gizmo in the lower left corner of the 3-D view: which way the axes point; a click looks along one.
#pragma once

#include <array>

#include "ui/scene/pick/camera.h"

namespace taxel::ui {

/// One ball of the gizmo: the end of +x, -x, +y, -y, +z or -z.
struct GizmoBall {
  int axis = 0;       ///< 0..5 in that order
  dvec2 pixel{0};     ///< centre, from the upper left corner of the view
  double toward = 0;  ///< -1 away from the eye .. +1 towards it
  [[nodiscard]] bool positive() const { return axis % 2 == 0; }
};

inline constexpr double kGizmoReach = 34;      ///< from the middle to the balls [pixel]
inline constexpr double kGizmoBallRadius = 9;  ///< [pixel]
inline constexpr double kGizmoMargin = 16;     ///< to the edges of the view [pixel]

/// In a view of this size. All pixels are those of scale 1.
dvec2 gizmo_center(const dvec2& view);
/// All six, farthest first: the order of drawing.
std::array<GizmoBall, 6> gizmo_balls(const Camera& camera, const dvec2& view);

/// The axis 0..5 under a pixel, the nearest to the eye first; -1 for none.
int gizmo_hit(const Camera& camera, const dvec2& at, const dvec2& view);
/// Turns the camera so that it looks from the end of that axis; target and distance stay.
void look_from_axis(Camera& camera, int axis);

}  // namespace taxel::ui
