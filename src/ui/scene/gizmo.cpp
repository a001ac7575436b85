#include "ui/scene/gizmo.h"

namespace taxel::ui {

dvec2 gizmo_center(int width, int height) {
  const double inset = kGizmoMargin + kGizmoReach + kGizmoBallRadius;
  return {std::min(inset, 0.5 * width), std::max(height - inset, 0.5 * height)};
}

std::array<GizmoBall, 6> gizmo_balls(const Camera& camera, int width, int height) {
  const glm::dmat3 view(camera.view());
  const dvec2 center = gizmo_center(width, height);
  std::array<GizmoBall, 6> balls;
  for (int axis = 0; axis < 6; ++axis) {
    const dvec3 d = (axis % 2 == 0 ? 1.0 : -1.0) * view[axis / 2];  // right, up, towards the eye
    balls[static_cast<std::size_t>(axis)] = {axis, center + kGizmoReach * dvec2(d.x, -d.y), d.z};
  }
  std::stable_sort(balls.begin(), balls.end(),
                   [](const GizmoBall& a, const GizmoBall& b) { return a.toward < b.toward; });
  return balls;
}

int gizmo_hit(const Camera& camera, double x, double y, int width, int height) {
  const auto balls = gizmo_balls(camera, width, height);
  for (auto ball = balls.rbegin(); ball != balls.rend(); ++ball) {
    if (glm::length(dvec2(x, y) - ball->pixel) <= kGizmoBallRadius) return ball->axis;
  }
  return -1;
}

void look_from_axis(Camera& camera, int axis) {
  constexpr double kStraight = 89.5;  // as near to the pole as the camera goes
  constexpr std::array<double, 4> azimuth{0, 180, 90, -90};
  if (axis < 0 || axis > 5) return;
  if (axis < 4) camera.azimuth_deg = azimuth[static_cast<std::size_t>(axis)];
  camera.elevation_deg = axis < 4 ? 0.0 : axis == 4 ? kStraight : -kStraight;
}

}  // namespace taxel::ui
