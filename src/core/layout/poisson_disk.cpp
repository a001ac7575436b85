#include "core/layout/poisson_disk.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/layout/point_grid.h"
#include "core/layout/sample_elimination.h"

namespace taxel {
namespace {

/// Every pool point gives its equal share of the area to the nearest sample on its wall.
void share_area(const SurfacePool& pool, double area, std::vector<SurfaceSample>& samples) {
  const double spacing = std::sqrt(area / static_cast<double>(samples.size()));
  std::vector<dvec3> positions;
  for (const SurfaceSample& s : samples) positions.push_back(s.position);
  const PointGrid grid(positions, spacing);
  std::vector<int> owner(static_cast<std::size_t>(pool.size()), -1);
  parallel_chunks(pool.size(), 1024, [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      double best = std::numeric_limits<double>::infinity();
      for (double radius = 1.5 * spacing; owner[i] < 0 || best > radius; radius *= 2.0) {
        grid.visit_near(pool.positions[i], radius, [&](int s) {
          const double d = glm::distance(positions[static_cast<std::size_t>(s)], pool.positions[i]);
          if (d < best || (d == best && s < owner[i])) best = d, owner[i] = s;
        });
      }
    }
  });
  for (SurfaceSample& s : samples) s.area = 0.0;
  for (const int o : owner) samples[static_cast<std::size_t>(o)].area += area / pool.size();
}

}  // namespace

int sample_count(double density, double area) {
  const double count = std::round(density * area);
  if (!(count >= 0.0 && count <= kMaxSamples))
    throw Error(fmt::format("density {} per square metre on {} square metres gives {} samples, the limit is {}",
                            density, area, count, kMaxSamples));
  return static_cast<int>(count);
}

std::vector<SurfaceSample> sample_surface(const TriMesh& mesh, int count, std::uint64_t seed, Progress* progress) {
  if (count < 0 || count > kMaxSamples)
    throw Error(fmt::format("{} samples asked for, the limits are 0 and {}", count, kMaxSamples));
  if (count == 0) return {};
  const int pool_factor = 4;  // Yuksel 2015, section 3: more helps little
  const SurfacePool pool = make_surface_pool(mesh, pool_factor * count, seed);
  const std::vector<int> kept = eliminate_samples(pool, count, mesh.area(), progress);

  std::vector<SurfaceSample> samples;
  samples.reserve(kept.size());
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    samples.push_back({pool.positions[i], pool.normals[i], pool.faces[i], 0.0});
  }
  share_area(pool, mesh.area(), samples);
  return samples;
}

}  // namespace taxel
