#include "ui/scene/pick/gizmo.h"

namespace taxel::ui {

dvec2 gizmo_center(const dvec2& view) {
  const double inset = kGizmoMargin + kGizmoReach + kGizmoBallRadius;
  return {std::min(inset, 0.5 * view.x), std::max(view.y - inset, 0.5 * view.y)};
}

std::array<GizmoBall, 6> gizmo_balls(const Camera& camera, const dvec2& view) {
  const glm::dmat3 axes(camera.view());
  const dvec2 center = gizmo_center(view);
  std::array<GizmoBall, 6> balls;
  for (int axis = 0; axis < 6; ++axis) {
    const dvec3 d = (axis % 2 == 0 ? 1.0 : -1.0) * axes[axis / 2];  // right, up, towards the eye
    balls[static_cast<std::size_t>(axis)] = {axis, center + kGizmoReach * dvec2(d.x, -d.y), d.z};
  }
  std::stable_sort(balls.begin(), balls.end(),
                   [](const GizmoBall& a, const GizmoBall& b) { return a.toward < b.toward; });
  return balls;
}

int gizmo_hit(const Camera& camera, const dvec2& at, const dvec2& view) {
  const auto balls = gizmo_balls(camera, view);
  for (auto ball = balls.rbegin(); ball != balls.rend(); ++ball) {
    if (glm::distance(at, ball->pixel) <= kGizmoBallRadius) return ball->axis;
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

void take_standard_view(Camera& camera, int axis) {
  look_from_axis(camera, axis);
  camera.roll_deg = 0;
  if (axis < 4) return;
  camera.azimuth_deg = -90;
  camera.elevation_deg = axis == 4 ? 90 : -90;
}

const char* standard_view_name(const Camera& camera) {
  constexpr std::array<const char*, 6> kNames{"Right", "Left", "Back", "Front", "Top", "Bottom"};
  for (int axis = 0; axis < 6; ++axis) {
    Camera standard = camera;
    take_standard_view(standard, axis);
    if (standard == camera) return kNames[static_cast<std::size_t>(axis)];
  }
  return "";
}

}  // namespace taxel::ui
