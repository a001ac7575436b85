// The receptive fields as functions on the skin: the weight of every taxel at any point, for integrals without samples.
#pragma once

#include <memory>
#include <vector>

#include "core/layout/field/field_disc.h"
#include "core/layout/field/point_grid.h"
#include "core/mesh/geodesic/geodesic_map.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// The weights that ReceptiveFields defines for samples: w = (r - d)^2 c if d <= r and the normal of the skin is less
/// than the angle limit from the normal of the disc, with the factor c of FieldAngle; with subtaxels, r, d and c of the
/// nearest subtaxel. Immutable, so threads can share it.
class FieldWeights {
 public:
  struct Weight {
    int taxel = 0;      ///< index in layout order
    double value = 0;   ///< w, never negative [m^2]
    double facing = 0;  ///< c, greater than 0 and at most 1
  };
  /// The fields at one point. The object is reused between calls, so that no call allocates memory.
  struct AtPoint {
    std::vector<Weight> weights;  ///< weights by ascending id, so sums do not depend on the order of the taxels
    /// Distance of the point from the edge of the area that the fields cover together, along the known path across the
    /// edge: the largest r - d of the discs that cover the face, negative outside [m].
    double margin = 0;
    /// The largest factor c of the taxels with a weight greater than 0; 0 without one. It is 1 without a roll-off.
    double cover = 0;
  };

  /// A disc of a taxel.
  struct Disc {
    FieldDisc disc;
    int taxel = 0;
    dvec3 origin{0};  ///< origin of distances: the stored centre, or its closest point on the skin
  };

  /// `skin` has the outer shells, as for make_receptive_fields(). With geodesic distances, memory and time are those of
  /// one propagation per disc.
  FieldWeights(const Layout& layout, const MeshIndex& skin);

  /// Sets `discs` to the discs, ascending, that may contain points of the skin within `reach` of p.
  void near(const dvec3& p, double reach, std::vector<int>& discs) const;
  /// Computes the weights at a point of a face of the skin, only for `discs` (ascending).
  void at(int face, const dvec3& point, std::span<const int> discs, AtPoint& out) const;
  /// Computes the weights at a point where the skin has another unit normal than the face: on an edge or a corner, a
  /// normal between those of its faces. FieldNormals::interpolated takes the interpolated normal in place of `normal`.
  void at(int face, const dvec3& point, const dvec3& normal, std::span<const int> discs, AtPoint& out) const;
  /// Returns the smallest radius of `discs` [m]; infinite if there are none.
  [[nodiscard]] double smallest_radius(std::span<const int> discs) const;

  /// Returns a disc by its number. Numbers ascend with the ids of the taxels.
  [[nodiscard]] const Disc& disc(int number) const { return discs_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] const FieldAngle& angle() const { return angle_; }
  [[nodiscard]] FieldNormals normals() const { return normals_; }
  [[nodiscard]] bool geodesic() const { return !paths_.empty(); }  ///< true if distances are along the skin
  /// Returns the distance of a point of a face from the origin of a disc; infinite if no known path leads there [m].
  [[nodiscard]] double distance(int disc, int face, const dvec3& point) const;

 private:
  TriMeshPtr skin_;
  FieldAngle angle_;
  FieldNormals normals_;
  double largest_radius_ = 0;
  std::vector<Disc> discs_;         // discs by ascending id of the taxel
  std::vector<GeodesicMap> paths_;  // paths of each disc; empty for Euclidean distances
  PointGrid grid_{{}, 1.0};         // grid of the origins
};

}  // namespace taxel
