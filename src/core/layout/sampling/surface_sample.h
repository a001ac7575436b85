// One sample of a surface: a point with the part of the surface that it represents. A pool: many random points on a
// mesh, distributed in proportion to area, from which samplers choose.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

struct SurfaceSample {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};  ///< unit normal of the face
  int face = -1;
  double area = 0.0;   ///< represented area [m^2]; all samples sum to the sampled area
  double share = 1.0;  ///< number of samples of the layout's density that it represents
};

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
