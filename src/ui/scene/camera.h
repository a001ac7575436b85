// An orbit camera with z up, which looks at a target, with or without perspective; the plane that cuts the sensor open
// in the view; and the XYZ gizmo in its corner. Pure values and maths, tested without GL.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>

#include "core/base/math.h"
#include "core/mesh/query/bvh.h"

namespace taxel::ui {

struct Camera {
  dvec3 target{0, 0, 0};      ///< target in the world [m]
  double azimuth_deg = 135;   ///< direction from target to eye, angle about +z from +x
  double elevation_deg = 25;  ///< angle of the eye above the horizon, in (-90, 90)
  double distance = 0.15;     ///< distance from eye to target, as if in perspective [m]
  double fov_deg = 40;        ///< vertical field of view
  double roll_deg = 0;        ///< rotation of the image about the line of sight, to the left
  /// Draws parallel lines of the scene in parallel. The view has the height that the perspective one has at `target`.
  bool orthographic = false;

  /// Returns the eye. Of an orthographic camera it is so far away that all sight lines in the view are nearly parallel,
  /// and that nothing in front of the target is behind it.
  [[nodiscard]] dvec3 eye() const;
  [[nodiscard]] glm::dmat4 view() const;
  /// Returns the projection, whose near and far planes scale with the distance.
  [[nodiscard]] glm::dmat4 projection(double aspect) const;
  [[nodiscard]] double near_plane() const;  ///< distance of the near plane [m]
  /// Returns the pixel of a world point, from the top left corner of the view; z is the depth in front of the eye, <= 0
  /// behind it.
  [[nodiscard]] dvec3 project(const dvec3& p_W, int width, int height) const;
  /// Returns the size of a pixel at a depth in front of the eye [m].
  [[nodiscard]] double pixel_size(double depth, int height) const;
  /// Returns the distance whose fractions are tolerances of depth [m]: `depth` itself, or of an orthographic camera the
  /// distance of the target, because the eye is only a far point.
  [[nodiscard]] double depth_scale(double depth) const { return orthographic ? distance : depth; }
  /// Returns the world ray through a pixel.
  [[nodiscard]] Ray pixel_ray(double x, double y, int width, int height) const;

  /// Returns the world point under a pixel, at the depth of the target.
  [[nodiscard]] dvec3 point_under(double x, double y, int width, int height) const;

  /// Turns about the target: about the vertical and across it, or, if the image is rolled, about the axes of the image.
  void orbit(double dx_pixels, double dy_pixels);
  void pan(double dx_pixels, double dy_pixels, int height, bool horizontal = false);
  void zoom(double wheel_notches);
  /// Zooms with a world point as the fixed point: its pixel does not change.
  void zoom_at(double wheel_notches, const dvec3& p_W);
  void frame(const Aabb& box_W);
  /// Sets the camera to look from a pose along its -z, with y up, at a target at distance `depth`.
  void look_from(const Pose& X_WC, double depth);

  bool operator==(const Camera&) const = default;
};

/// A clip plane in the world. Points with dot(normal, p) > offset are hidden.
struct ClipPlane {
  dvec3 normal{0, 0, 1};  ///< unit normal
  double offset = 0;      ///< [m]
  bool operator==(const ClipPlane&) const = default;

  [[nodiscard]] double height(const dvec3& p_W) const { return glm::dot(normal, p_W) - offset; }
  [[nodiscard]] bool hides(const dvec3& p_W) const { return height(p_W) > 0; }
  [[nodiscard]] ClipPlane flipped() const { return {-normal, -offset}; }
};

/// The part of a ray that is not clipped, and the distance that its origin moved; empty if the whole ray is clipped.
struct ShownRay {
  Ray ray;
  double moved = 0;
};
inline std::optional<ShownRay> shown_part(const std::optional<ClipPlane>& clip, Ray ray_W) {
  if (!clip) return ShownRay{ray_W, 0};
  const double height = clip->height(ray_W.origin), rise = glm::dot(clip->normal, ray_W.direction);
  if (height <= 0) {
    if (rise > 0) ray_W.t_max = std::min(ray_W.t_max, -height / rise);
    return ShownRay{ray_W, 0};
  }
  if (rise >= 0 || -height / rise > ray_W.t_max) return std::nullopt;
  const double moved = -height / rise;
  ray_W.origin += moved * ray_W.direction;
  ray_W.t_max -= moved;
  return ShownRay{ray_W, moved};
}

// The gizmo shows the directions of the axes; a click on an axis looks along it.

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
