// Computes the surface of equal pressure of two soft bodies that press each other deeper than their tets, by marching
// tetrahedra (Doi, Koide 1991) on p_b - p_a.
#pragma once

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/law_match.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {

/// The pressure of a soft body at any point: (E/H) D in a pad, the pressure of the tets in another field, and linear in
/// a half-space. Negative outside.
class PressureAt {
 public:
  /// X_BL is the pose of the lattice's frame L in the body's frame. The pressures of a pad are those of `match`, or
  /// linear if it is null; `field` has them already.
  PressureAt(const DepthField* depth, const FieldIndex& field, const RigidTransform& X_BL,
             const LawMatch* match = nullptr);
  /// Sets the pressure of the half-space z <= 0.
  PressureAt(double stiffness, double thickness, const RigidTransform& X_BL);

  /// Returns the pressure at x, frame L. `within` is an upper bound of the distance to a pad's skin.
  [[nodiscard]] double value(const dvec3& x_L, double within = std::numeric_limits<double>::infinity()) const;
  /// Returns the pressure at x, which is at most `distance` from a point with pressure `near`.
  [[nodiscard]] double value_near(const dvec3& x_L, double near, double distance) const;
  [[nodiscard]] double stiffness() const { return stiffness_; }  ///< largest gradient [Pa/m]
  [[nodiscard]] double thickness() const { return thickness_; }  ///< scale of the lattice [m]
  /// Returns the box in which the pressure is positive, frame L; it is infinite for a half-space.
  [[nodiscard]] const Aabb& bounds_L() const { return bounds_L_; }

 private:
  [[nodiscard]] double value_in_tets(const dvec3& x) const;
  void set_bounds(const Aabb& bounds);

  const DepthField* depth_ = nullptr;
  const FieldIndex* field_ = nullptr;
  const LawMatch* match_ = nullptr;
  RigidTransform X_BL_;
  double stiffness_ = 0, thickness_ = 0;
  Aabb bounds_L_;
};

/// Returns a frame halfway between the frames A and B, as a pose in A. It does not change if the bodies are exchanged,
/// and moves with the bodies if both move together.
RigidTransform frame_between(const Pose& X_AB);

/// Returns true if the first vertex of one body is inside the other body at a place without tets. Surfaces of equal
/// pressure that intersect no tet are possible then. X_AB is the pose of b in a.
bool reaches_core(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB);

/// Adds the surface of equal pressures, except for parts that polygons of the writer's surface already cover: from
/// workspace.core_points on, or, where these are empty, anywhere. X_SL: pose of the lattice's frame in the writer's
/// frame S. The surface's triangles have the normal of growing second - first; `own`, one of the two, is the body whose
/// gradient they get. Polygons name no tet.
void add_march(const PressureAt& first, const PressureAt& second, const PressureAt& own, const RigidTransform& X_SL,
               const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace);

}  // namespace taxel
