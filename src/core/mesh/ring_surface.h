// Triangles between rings of points stacked along an axis: how round meshes are made.
#pragma once

#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A surface made of rings, each counter-clockwise seen from where the rings go to (bottom to top: seen from above).
/// Rings may have different numbers of points; a ring of one point is a pole. Faces look away from the axis when the
/// rings begin at the bottom.
class RingSurface {
 public:
  /// Adds a ring and joins it to the one before, always along the shorter diagonal.
  void add_ring(const std::vector<dvec3>& ring);
  /// The mesh of all rings. Closed when the first and the last ring are poles.
  [[nodiscard]] TriMesh mesh() const { return {vertices_, faces_}; }

 private:
  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_;
  int first_ = 0, count_ = 0;  ///< of the last ring
};

}  // namespace taxel
