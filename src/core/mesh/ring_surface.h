// Triangles between rings of points stacked along an axis: how round meshes are made.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Joins two rows of points, both running to the right seen from outside with `upper` above: one triangle per step of
/// either row, along the shorter diagonals, but never along one that makes a valley. Appends to `faces`,
/// counter-clockwise seen from outside.
void join_rows(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper,
               std::vector<ivec3>& faces);

/// A surface made of rings, each counter-clockwise seen from where the rings go to (bottom to top: seen from above).
/// Rings may have different numbers of points; a ring of one point is a pole. Faces look away from the axis when the
/// rings begin at the bottom.
class RingSurface {
 public:
  /// Adds a ring and joins it to the one before.
  void add_ring(const std::vector<dvec3>& ring);
  /// The mesh of all rings. Closed when the first and the last ring are poles.
  [[nodiscard]] TriMesh mesh() const { return {vertices_, faces_}; }

 private:
  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_;
  std::vector<int> last_;  ///< the last ring, its first point again at the end
};

/// The same for surfaces that are mirror images of themselves in the plane x = 0, exactly, bit by bit: made of half
/// rings from the front (-y) through +x to the back (+y), whose ends have x == 0. One point is a pole.
class MirroredRingSurface {
 public:
  void add_half_ring(const std::vector<dvec3>& half_ring);
  [[nodiscard]] TriMesh mesh() const { return {vertices_, faces_}; }

 private:
  std::vector<dvec3> vertices_;
  std::vector<int> mirror_;  ///< for each vertex its mirror image; itself on the plane
  std::vector<ivec3> faces_;
  std::vector<int> last_;
};

}  // namespace taxel
