// One part of a surface that has its own density of samples.
#pragma once

#include <vector>

#include "core/layout/field/point_grid.h"
#include "core/layout/sampling/dense_disc.h"
#include "core/layout/sampling/surface_pool.h"

namespace taxel {

/// The faces of a surface near a part, cut into triangles of about the size of the part.
struct PartSurface {
  TriMesh mesh;
  std::vector<int> face_of;  ///< face of the whole surface, of each triangle
};

/// The union of discs of one density. Immutable, so threads can share it.
class DensePart {
 public:
  /// `usual_density` is that of the samples around the part [1/m^2].
  DensePart(std::vector<DenseDisc> discs, double usual_density);

  [[nodiscard]] double density() const { return discs_.front().density; }
  [[nodiscard]] double spacing() const { return spacing_; }  ///< spacing of the densest packing [m]

  /// Returns true if the cell of a usual sample, on a face with this normal, can reach into a disc.
  [[nodiscard]] bool has(const dvec3& point, const dvec3& normal) const;
  /// Returns true if a point is within a distance of the patch: the cells of the samples that has() accepts, and a
  /// border of 3 spacings.
  [[nodiscard]] bool is_within(const dvec3& point, double distance) const;
  /// Returns the distance from a disc at which the patch ends [m].
  [[nodiscard]] double patch_reach() const;

  /// Returns the faces of `mesh` in the patch, and some around it.
  [[nodiscard]] PartSurface surface(const TriMesh& mesh) const;
  /// Returns `per_sample` times `density` points per area of the patch, each in its own piece of equal area
  /// (make_surface_pool()). Throws Error if they are too many.
  [[nodiscard]] SurfacePool pool(const TriMesh& mesh, const PartSurface& near, int per_sample,
                                 std::uint64_t seed) const;

 private:
  template <class Accept>
  [[nodiscard]] bool any_disc(const dvec3& point, double reach, const Accept& accept) const;

  std::vector<DenseDisc> discs_;
  double spacing_ = 0, usual_spacing_ = 0, largest_radius_ = 0;
  PointGrid centers_;
};

/// Returns the parts of discs denser than `density`, by ascending density, then in the order of their first discs.
/// Discs of one density whose patches overlap make one part.
std::vector<DensePart> dense_parts(std::vector<DenseDisc> discs, double density);

}  // namespace taxel
