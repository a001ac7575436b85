// A pool of points of a surface, from which samplers choose.
//
// Independent points would leave clusters and gaps from which no choice recovers. So the faces are put in a row in
// which neighbours are near each other (Morton order of their centroids: the bits of x, y and z interleaved), the row
// is divided into as many parts of equal area as there are points, and each part gets one point at random. The number
// of points of a neighbourhood is then its area, up to one or two points.
//
// Random numbers are functions of the seed and the number of the point, so threads do not change a bit. Cost: O(n log
// n) for n faces, and a binary search per point.
#include "core/layout/sampling/surface_sample.h"

#include "core/base/parallel.h"
#include "core/base/rng.h"

namespace taxel {
namespace {

/// Spreads the low 21 bits of v to every third bit.
std::uint64_t spread_bits(std::uint64_t v) {
  v = (v | (v << 32)) & 0x001f00000000ffffULL;
  v = (v | (v << 16)) & 0x001f0000ff0000ffULL;
  v = (v | (v << 8)) & 0x100f00f00f00f00fULL;
  v = (v | (v << 4)) & 0x10c30c30c30c30c3ULL;
  return (v | (v << 2)) & 0x1249249249249249ULL;
}

/// Faces in Morton order of their centroids; ties by face number.
std::vector<int> spatial_order(const TriMesh& mesh) {
  const double cells = 0x1.0p21 - 1.0;
  const dvec3 extent = glm::max(mesh.bounds().extent(), dvec3(std::numeric_limits<double>::min()));
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const dvec3 c = (mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0;
    const dvec3 u = glm::clamp((c - mesh.bounds().lo) / extent, dvec3(0), dvec3(1)) * cells;
    keys.emplace_back(spread_bits(static_cast<std::uint64_t>(u.x)) | spread_bits(static_cast<std::uint64_t>(u.y)) << 1 |
                          spread_bits(static_cast<std::uint64_t>(u.z)) << 2,
                      f);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace

SurfacePool make_surface_pool(const TriMesh& mesh, int count, std::uint64_t seed) {
  const std::vector<int> order = spatial_order(mesh);
  std::vector<double> area_up_to(order.size());  // inclusive
  double total = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
    area_up_to[i] = total += mesh.face_areas()[static_cast<std::size_t>(order[i])];

  SurfacePool pool;
  const auto size = static_cast<std::size_t>(count);
  pool.positions.resize(size);
  pool.normals.resize(size);
  pool.faces.resize(size);
  const CounterRng along(seed, 0), first(seed, 1), second(seed, 2);
  parallel_chunks(count, 4096, [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      const double at = (static_cast<double>(i) + along.uniform(i)) / static_cast<double>(count) * total;
      const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, at);
      const int face = order[static_cast<std::size_t>(found - area_up_to.begin())];
      // Uniform in the triangle (Osada et al. 2002).
      const double s = std::sqrt(first.uniform(i)), t = second.uniform(i);
      pool.positions[i] =
          (1.0 - s) * mesh.vertex(face, 0) + s * (1.0 - t) * mesh.vertex(face, 1) + s * t * mesh.vertex(face, 2);
      pool.normals[i] = mesh.face_normals()[static_cast<std::size_t>(face)];
      pool.faces[i] = face;
    }
  });
  return pool;
}

}  // namespace taxel
