// Nearest points of a mesh from a guess of the face, for queries that move little: a few comparisons prove most
// guesses, and only the others need a search in the tree.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel {

/// The faces around each face that may have a nearer point. Immutable.
///
/// Let s be the foot of x on the plane of face f, inside of f and at the distance h <= `most` behind it. A point y is
/// nearer to x than s only if it is inside of the ball about x through s, which touches f from behind. For most faces
/// no such ball of a radius up to `most` reaches them. The others are listed for f, and f has the nearest point if none
/// of their planes is nearer to x than h.
class NearestGuess {
 public:
  /// `most` is the largest distance for which guesses are to be proved [m]. The index must outlive this object.
  NearestGuess(const MeshIndex& index, double most);

  /// Returns index.closest_point(x) up to rounding. `guess` is a face, or -1 without a guess, and gets the face of the
  /// result.
  [[nodiscard]] SurfacePoint closest_point(const dvec3& x, int& guess) const;

 private:
  [[nodiscard]] int nearer_plane(int face, const dvec3& x, double within) const;
  [[nodiscard]] int across(int face, const dvec3& barycentric) const;
  [[nodiscard]] std::vector<int> faces_around(int face) const;
  [[nodiscard]] bool may_be_nearer(int face, int other) const;

  const MeshIndex& index_;
  std::vector<std::uint32_t> first_;  ///< the faces around face f are around_ [first_[f], first_[f + 1]), ascending
  std::vector<int> around_;
  std::vector<double> nx_, ny_, nz_, offset_;  ///< planes of around_: n x + offset = 0
  double most_ = 0, slack_ = 0;
};

}  // namespace taxel
