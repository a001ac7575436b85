// The receptive fields as functions on the skin: the weight of every taxel at any point, for integrals that take no
// samples.
#pragma once

#include <memory>
#include <vector>

#include "core/layout/field/field_disc.h"
#include "core/layout/field/point_grid.h"
#include "core/mesh/geodesic/geodesic_map.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// As ReceptiveFields defines them for samples: w = (r - d)^2 where d <= r and the face is less than the angle limit
/// from the normal, with subtaxels r and d of the nearest one. Immutable; safe to share between threads.
class FieldWeights {
 public:
  struct Weight {
    int taxel = 0;     ///< in layout order
    double value = 0;  ///< w, never negative [m^2]
  };
  /// The fields at one point. The object is reused between calls, so that no call allocates memory.
  struct AtPoint {
    std::vector<Weight> weights;  ///< by ascending id: sums do not depend on the order of the taxels
    /// Distance of the point from the edge of the area that the fields cover together, along the known path across the
    /// edge: the largest r - d of the discs that cover the face, negative outside [m].
    double margin = 0;
  };

  /// `skin`: outer shells, as for make_receptive_fields(). With geodesic distances memory and time are those of one
  /// propagation per disc.
  FieldWeights(const Layout& layout, const MeshIndex& skin);

  /// Replaces `discs` by those that may hold points of the skin within `reach` of p, ascending.
  void near(const dvec3& p, double reach, std::vector<int>& discs) const;
  /// At a point of a face of the skin; of `discs` alone (ascending).
  void at(int face, const dvec3& point, std::span<const int> discs, AtPoint& out) const;
  /// The same where the skin has another unit normal than the face: on an edge or a corner, one between its faces'.
  void at(int face, const dvec3& point, const dvec3& normal, std::span<const int> discs, AtPoint& out) const;
  /// The smallest radius among discs [m]; infinite for none.
  [[nodiscard]] double smallest_radius(std::span<const int> discs) const;

 private:
  struct Disc {
    FieldDisc disc;
    int taxel = 0;
    dvec3 origin{0};  ///< origin of distances: the stored centre, or its closest point on the skin
  };
  [[nodiscard]] double distance(std::size_t disc, int face, const dvec3& point) const;

  TriMeshPtr skin_;
  double min_cosine_ = 0, largest_radius_ = 0;
  std::vector<Disc> discs_;         // by ascending id of the taxel
  std::vector<GeodesicMap> paths_;  // by disc; empty for straight distances
  PointGrid grid_{{}, 1.0};         // of the origins
};

}  // namespace taxel
