// An orbit camera with z up, which looks at a target, with or without perspective. Pure values and maths, tested
// without GL.
#pragma once

#include <glm/glm.hpp>

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

  void orbit(double dx_pixels, double dy_pixels);
  void pan(double dx_pixels, double dy_pixels, int height, bool horizontal = false);
  void zoom(double wheel_notches);
  void frame(const Aabb& box_W);
  /// Sets the camera to look from a pose along its -z, with y up, at a target at distance `depth`.
  void look_from(const Pose& X_WC, double depth);

  bool operator==(const Camera&) const = default;
};

}  // namespace taxel::ui
