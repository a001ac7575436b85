// Builds round meshes from rings of points stacked along an axis.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Joins two rows of points by triangles. Seen from outside, both rows run to the right, and `upper` is above. Each
/// step of either row gives one triangle; diagonals are as short as possible, but no diagonal may make the surface
/// concave. Appends to `faces`, counter-clockwise seen from outside.
void join_rows(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper,
               std::vector<ivec3>& faces);

/// A surface of rings from bottom to top, each counter-clockwise seen from above. Rings may have different numbers of
/// points; a ring of one point is a pole. Faces look away from the axis.
class RingSurface {
 public:
  /// Adds a ring and joins it to the previous ring.
  void add_ring(const std::vector<dvec3>& ring);
  /// Returns the mesh of all rings, which is closed if the first and the last ring are poles.
  [[nodiscard]] TriMesh mesh() const { return {vertices_, faces_}; }

 private:
  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_;
  std::vector<int> last_;  ///< points of the last ring, with the first one again at the end
};

/// A surface of rings that is its own mirror image in the plane x = 0, bit by bit. Each half ring runs from the front
/// (-y) through +x to the back (+y), and its ends have x == 0. A half ring of one point is a pole.
class MirroredRingSurface {
 public:
  void add_half_ring(const std::vector<dvec3>& half_ring);
  [[nodiscard]] TriMesh mesh() const { return {vertices_, faces_}; }

 private:
  std::vector<dvec3> vertices_;
  std::vector<int> mirror_;  ///< mirror image of each vertex; the vertex itself on the plane
  std::vector<ivec3> faces_;
  std::vector<int> last_;
};

}  // namespace taxel
