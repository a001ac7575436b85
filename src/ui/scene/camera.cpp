#include "ui/scene/camera.h"

#include <glm/gtc/matrix_transform.hpp>

namespace taxel::ui {
namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kElevationLimitDeg = 89.5;
constexpr double kZoomPerNotch = 0.88;
constexpr double kNearest = 1e-4, kFarthest = 1e3;  // of `distance` [m]: a tenth of a millimetre to a kilometre
constexpr double kNearPart = 0.02, kFarPart = 50;   // of `distance`: near and far plane
constexpr double kOrthographicEye = 100;            // of `distance`: distance of the eye without perspective
constexpr double kFrameMargin = 1.1;
constexpr double kStraightDown = 1e-13;  // a shorter horizontal part of a unit vector has no direction

/// The directions right, up and backward of the view: an orthonormal right-handed basis.
struct Basis {
  dvec3 right, up, back;
};

Basis basis(const Camera& camera) {
  const double az = glm::radians(camera.azimuth_deg), el = glm::radians(camera.elevation_deg);
  const dvec3 back(std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el));
  const dvec3 level(-std::sin(az), std::cos(az), 0), upright = glm::cross(back, level);
  if (camera.roll_deg == 0) return {level, upright, back};
  const double roll = glm::radians(camera.roll_deg);
  const dvec3 right = std::cos(roll) * level + std::sin(roll) * upright;
  return {right, glm::cross(back, right), back};
}

double half_height(const Camera& camera) {
  return std::tan(0.5 * glm::radians(camera.fov_deg));
}

}  // namespace

dvec3 Camera::eye() const {
  return target + (orthographic ? kOrthographicEye * distance : distance) * basis(*this).back;
}

glm::dmat4 Camera::view() const {
  const Basis b = basis(*this);
  const dvec3 e = eye();
  glm::dmat4 m(1.0);
  for (int i = 0; i < 3; ++i) {
    m[i][0] = b.right[i];
    m[i][1] = b.up[i];
    m[i][2] = b.back[i];
  }
  m[3] = {-glm::dot(b.right, e), -glm::dot(b.up, e), -glm::dot(b.back, e), 1};
  return m;
}

glm::dmat4 Camera::projection(double aspect) const {
  if (!orthographic) return glm::perspective(glm::radians(fov_deg), aspect, near_plane(), kFarPart * distance);
  const double up = half_height(*this) * distance, right = aspect * up;
  return glm::ortho(-right, right, -up, up, near_plane(), 2 * kOrthographicEye * distance);
}

double Camera::near_plane() const {
  return kNearPart * distance;
}

dvec3 Camera::project(const dvec3& p_W, int width, int height) const {
  const Basis b = basis(*this);
  const dvec3 d = p_W - eye();
  const double depth = -glm::dot(b.back, d);
  const double pixels = 0.5 * height / (half_height(*this) * depth_scale(depth));  // per metre at that depth
  return {0.5 * width + pixels * glm::dot(b.right, d), 0.5 * height - pixels * glm::dot(b.up, d), depth};
}

double Camera::pixel_size(double depth, int height) const {
  return 2.0 * half_height(*this) * depth_scale(depth) / std::max(1, height);
}

Ray Camera::pixel_ray(double x, double y, int width, int height) const {
  const Basis b = basis(*this);
  const double scale = 2.0 * half_height(*this) / height;  // view units per pixel at depth 1
  const dvec3 aside = (x - 0.5 * width) * scale * b.right + (0.5 * height - y) * scale * b.up;
  Ray ray;
  ray.origin = orthographic ? eye() + distance * aside : eye();
  ray.direction = orthographic ? -b.back : glm::normalize(aside - b.back);
  return ray;
}

dvec3 Camera::point_under(double x, double y, int width, int height) const {
  const Ray ray = pixel_ray(x, y, width, height);
  const dvec3 back = basis(*this).back;
  return ray.origin + glm::dot(back, target - ray.origin) / glm::dot(back, ray.direction) * ray.direction;
}

void Camera::orbit(double dx_pixels, double dy_pixels) {
  if (roll_deg != 0) {
    const Basis b = basis(*this);
    const dquat aside = glm::angleAxis(-glm::radians(kDegreesPerPixel * dx_pixels), b.up);
    const dquat turn = aside * glm::angleAxis(-glm::radians(kDegreesPerPixel * dy_pixels), b.right);
    const dquat q = turn * glm::quat_cast(dmat3(b.right, b.up, b.back));
    return look_from(Pose{glm::normalize(q), target + distance * (turn * b.back)}, distance);
  }
  azimuth_deg = std::remainder(azimuth_deg - kDegreesPerPixel * dx_pixels, 360.0);
  elevation_deg = std::clamp(elevation_deg + kDegreesPerPixel * dy_pixels, -kElevationLimitDeg, kElevationLimitDeg);
}

void Camera::pan(double dx_pixels, double dy_pixels, int height, bool horizontal) {
  const Basis b = basis(*this);
  const double metres = 2.0 * distance * half_height(*this) / height;  // per pixel at the target
  const dvec3 away = glm::cross(dvec3(0, 0, 1), b.right);              // from the eye, level
  target -= metres * dx_pixels * b.right;
  target += metres * dy_pixels * (horizontal ? away : b.up);
}

void Camera::zoom(double wheel_notches) {
  distance = std::clamp(distance * std::pow(kZoomPerNotch, wheel_notches), kNearest, kFarthest);
}

void Camera::zoom_at(double wheel_notches, const dvec3& p_W) {
  const double before = distance;
  zoom(wheel_notches);
  target = p_W + distance / before * (target - p_W);
}

void Camera::look_from(const Pose& X_WC, double depth) {
  const dmat3 R = X_WC.rotation();
  const dvec3 &right = R[0], &back = R[2];
  const double level_part = std::hypot(back.x, back.y);
  elevation_deg = glm::degrees(std::atan2(back.z, level_part));
  azimuth_deg = glm::degrees(level_part > kStraightDown ? std::atan2(back.y, back.x) : std::atan2(-right.x, right.y));
  roll_deg = 0;
  const Basis unrolled = basis(*this);
  roll_deg = glm::degrees(std::atan2(glm::dot(right, unrolled.up), glm::dot(right, unrolled.right)));
  distance = std::clamp(depth, kNearest, kFarthest);
  target = X_WC.p - distance * back;
}

void Camera::frame(const Aabb& box_W) {
  if (box_W.empty()) return;
  target = box_W.center();
  const double radius = 0.5 * box_W.diagonal();
  if (radius > 0) {
    distance = std::clamp(kFrameMargin * radius / std::sin(0.5 * glm::radians(fov_deg)), kNearest, kFarthest);
  }
}

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
