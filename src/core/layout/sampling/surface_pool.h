// Many random points on a mesh, spread in proportion to area: what samplers choose from.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SurfacePool {
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;  ///< normals of the faces
  std::vector<int> faces;
  [[nodiscard]] int size() const { return static_cast<int>(positions.size()); }
};

/// `count` points, one in each of `count` parts of equal area along a walk over the faces in Morton order of their
/// centroids, so that every neighbourhood gets its share to within one or two points. Pure function of its arguments.
SurfacePool make_surface_pool(const TriMesh& mesh, int count, std::uint64_t seed);

}  // namespace taxel
