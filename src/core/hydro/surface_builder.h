// Adds polygons, found in the frame of the soft body, to a contact surface in the frame of body A.
#pragma once

#include <span>

#include "core/hydro/contact_surface.h"

namespace taxel {

/// A pressure that is linear in space, frame S of the soft body: p(x) = dot(gradient, x) + constant.
struct LinearPressure {
  dvec3 gradient{0};    ///< [Pa/m]
  double constant = 0;  ///< [Pa]
};

/// Where a polygon comes from.
struct PolygonSource {
  int tet = -1, face = -1;
  double size = 0;  ///< of the tet, or of the triangle where there is none: the scale of tolerances [m]
};

class SurfaceBuilder {
 public:
  /// Vertices nearer to each other than this part of the source's size become one. Area, centroid and pressure are
  /// those of the polygon before that, so that merging moves no force.
  static constexpr double kMergeDistance = 1e-6;
  /// A polygon whose area is a smaller part of the source's size squared is rejected as "sliver".
  static constexpr double kSliverArea = 1e-12;
  /// A polygon whose pressure is a smaller part of what grows over the source's size lies in the skin: "touching".
  static constexpr double kTouchingPressure = 1e-12;

  /// Clears `out`. X_AS is the pose of the soft body's frame in A.
  SurfaceBuilder(ContactSurface& out, const RigidTransform& X_AS, bool soft_is_a);

  /// points_S: a convex polygon, counter-clockwise about normal_S, the rigid body's outward unit normal. At most
  /// kMaxVertices points. False when it was rejected.
  bool add(std::span<const dvec3> points_S, const dvec3& normal_S, const LinearPressure& pressure,
           const PolygonSource& source);
  /// Notes that the polygon just added ends on a rigid core.
  void count_at_core() { ++out_.at_core; }
  static constexpr int kMaxVertices = 16;

 private:
  bool reject(const char* reason, double area);
  void append_vertices(std::span<const dvec3> points_S, const LinearPressure& pressure, double merge_distance);

  ContactSurface& out_;
  const RigidTransform& X_AS_;
  bool soft_is_a_;
};

}  // namespace taxel
