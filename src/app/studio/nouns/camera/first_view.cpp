// The direction from which a camera looks at a layout, or at a robot hand, for the first time.
//
//          tip                  A layout is seen with its tip up, from its touching side and a little above: the eye is
//           |  / eye            in the plane of tip and pad, `kAboveDeg` above the pad's direction. A hand is seen
//    skin   | /  20 degrees     upright, at three quarters: `kThreeQuarterDeg` around the vertical from the direction
//     ------+------> pad        in which its palm and its fingers touch.
//
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "core/layout/layout.h"
#include "ui/scene/camera.h"

namespace taxel::ui {
namespace {

constexpr double kAboveDeg = 20;     ///< angle of the eye above the direction of the pad
constexpr double kEndAboveDeg = 45;  ///< the same angle, if the pad faces along the tip
constexpr double kThreeQuarterDeg = 45;
/// Taxels all around have a mean normal that is shorter than this and means nothing.
constexpr double kShortestMean = 0.2;
/// A direction whose part across another one is smaller than this is along the other one.
constexpr double kAlong = 0.35;
constexpr double kLeastRollDeg = 1e-6;  ///< a smaller roll is an error of rounding

/// Returns the sum of the unit normals of the taxels.
dvec3 sum_of_normals(const Layout& layout) {
  dvec3 sum(0);
  for (const Taxel& taxel : layout.taxels)
    if (const double length = glm::length(taxel.normal); length > 0) sum += taxel.normal / length;
  return sum;
}

/// Returns a vector without its part along a unit vector.
dvec3 across(const dvec3& v, const dvec3& unit) {
  return v - glm::dot(v, unit) * unit;
}

dvec3 any_across(const dvec3& unit) {
  const dvec3 axis = std::abs(unit.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(across(axis, unit));
}

/// Turns the camera to look from `back`, with `up` upward in the image. Target and distance follow by framing.
void look_along(Camera& camera, const dvec3& back, const dvec3& up) {
  const dvec3 right = glm::normalize(glm::cross(up, back));
  camera.look_from(Pose{glm::quat_cast(dmat3(right, glm::cross(back, right), back)), dvec3(0)}, camera.distance);
  if (std::abs(camera.roll_deg) < kLeastRollDeg) camera.roll_deg = 0;
}

/// Returns the touching side of a layout: the mean normal of its taxels, or the pad of its frame if it has no taxels or
/// taxels all around.
dvec3 touching_side(const Layout& layout) {
  const dvec3 sum = sum_of_normals(layout);
  const double mean = layout.taxels.empty() ? 0 : glm::length(sum) / static_cast<double>(layout.taxels.size());
  return mean > kShortestMean ? glm::normalize(sum) : glm::normalize(layout.frame.pad);
}

void look_at_pad(Camera& camera, const Layout& layout) {
  const dvec3 tip = glm::normalize(layout.frame.distal), pad = touching_side(layout);
  dvec3 level = across(pad, tip);
  double above = glm::radians(kAboveDeg);
  if (glm::length(level) < kAlong) {
    level = across(layout.frame.pad, tip);
    if (glm::length(level) < kAlong * glm::length(layout.frame.pad)) level = any_across(tip);
    above = glm::radians(glm::dot(pad, tip) > 0 ? kEndAboveDeg : -kEndAboveDeg);
  }
  look_along(camera, std::cos(above) * glm::normalize(level) + std::sin(above) * tip, tip);
}

/// Returns the mean direction in which the sensors of a scene touch, and whether it has one, world.
std::optional<dvec3> palm_direction(const SimFrame& frame) {
  dvec3 sum_W(0);
  double taxels = 0;
  for (const SensorStep& sensor : frame.sensors) {
    sum_W += sensor.X_WM.rotate(sum_of_normals(sensor.model->layout));
    taxels += static_cast<double>(sensor.model->taxel_count());
  }
  if (!(glm::length(sum_W) > kShortestMean * taxels)) return std::nullopt;
  return glm::normalize(sum_W);
}

void look_at_hand(Camera& camera, const SimFrame& frame) {
  const std::optional<dvec3> palm_W = palm_direction(frame);
  if (!palm_W || std::hypot(palm_W->x, palm_W->y) < kAlong) return;
  const double azimuth = std::atan2(palm_W->y, palm_W->x) + glm::radians(kThreeQuarterDeg);
  camera.azimuth_deg = std::remainder(glm::degrees(azimuth), 360.0);
  camera.elevation_deg = kAboveDeg;
  camera.roll_deg = 0;
}

}  // namespace

void look_at_touching_side(Viewer& viewer, const Shown& shown) {
  if (has_several_sensors(viewer, shown)) {
    look_at_hand(viewer.camera(), *shown.run.frame);
  } else if (!shown.shows_scene(viewer) && shown.document.model) {
    look_at_pad(viewer.camera(), shown.document.model->layout);
  }
}

}  // namespace taxel::ui
