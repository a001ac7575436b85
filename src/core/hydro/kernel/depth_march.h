// Two soft bodies that press each other deeper than their tets reach: the surface of equal pressure there, by marching
// tetrahedra (Doi, Koide 1991) on p_b - p_a.
#pragma once

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/depth_workspace.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/surface_writer.h"

namespace taxel {

/// The pressure of a soft body at any point: (E/H) D of a pad, that of the tets of another field, linear in a
/// half-space. Negative outside.
class PressureAt {
 public:
  /// X_BL: pose of the lattice's frame L in the body's frame.
  PressureAt(const DepthField* depth, const FieldIndex& field, const RigidTransform& X_BL);
  /// The half-space z <= 0.
  PressureAt(double stiffness, double thickness, const RigidTransform& X_BL);

  /// At x, frame L. `within`: an upper bound of the distance to a pad's skin.
  [[nodiscard]] double value(const dvec3& x_L, double within = std::numeric_limits<double>::infinity()) const;
  /// At x, `distance` away from a point where the pressure is `near`.
  [[nodiscard]] double value_near(const dvec3& x_L, double near, double distance) const;
  [[nodiscard]] double stiffness() const { return stiffness_; }  ///< largest gradient [Pa/m]
  [[nodiscard]] double thickness() const { return thickness_; }  ///< the scale of the lattice [m]
  /// Where the pressure is positive, frame L; a half-space has no end.
  [[nodiscard]] const Aabb& bounds_L() const { return bounds_L_; }

 private:
  [[nodiscard]] double value_in_tets(const dvec3& x) const;
  void set_bounds(const Aabb& bounds);

  const DepthField* depth_ = nullptr;
  const FieldIndex* field_ = nullptr;
  RigidTransform X_BL_;
  double stiffness_ = 0, thickness_ = 0;
  Aabb bounds_L_;
};

/// A frame half way between the frames A and B, as poses in A: it is the same one when the bodies change places, and
/// goes along when both move.
RigidTransform frame_between(const Pose& X_AB);

/// Whether a body's first vertex lies inside of the other one where that has no tets: surfaces of equal pressure can be
/// there that no tet meets. X_AB: pose of b in a.
bool reaches_core(const FieldIndex& a, const FieldIndex& b, const RigidTransform& X_AB);

/// Adds the surface where both pressures are equal, except for what polygons of the writer's surface already cover:
/// from workspace.core_points on, or, where these are empty, anywhere. X_SL: pose of the lattice's frame in the
/// writer's frame S. The surface's triangles have the normal of growing second - first; `own`, one of the two, is the
/// body whose gradient they get. Polygons name no tet.
void add_march(const PressureAt& first, const PressureAt& second, const PressureAt& own, const RigidTransform& X_SL,
               const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace);

}  // namespace taxel
