// Many random points on a mesh, distributed in proportion to area, from which samplers choose.
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

/// Returns `count` points, one in each of `count` parts of equal area along a path over the faces in Morton order of
/// their centroids. So the number of points in every neighbourhood is proportional to its area, up to one or two
/// points. The result depends only on the arguments.
SurfacePool make_surface_pool(const TriMesh& mesh, int count, std::uint64_t seed);

}  // namespace taxel
