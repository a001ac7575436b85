#include "core/layout/poisson_disk.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/layout/sample_elimination.h"
#include "core/layout/sample_spread.h"
#include "core/layout/voronoi_area.h"

namespace taxel {
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
  const int sweeps = 4;       // the closest pairs gain little from more
  const SurfacePool pool = make_surface_pool(mesh, pool_factor * count, seed);
  if (progress) progress->stage(0.1, 0.4);  // about their parts of the time, what else a sensor needs included
  const std::vector<int> kept = eliminate_samples(pool, count, mesh.area(), progress);

  std::vector<SurfaceSample> samples;
  samples.reserve(kept.size());
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    samples.push_back({pool.positions[i], pool.normals[i], pool.faces[i], 0.0});
  }
  const double spacing = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * count));  // of the hexagonal packing
  const MeshIndex surface(TriMeshPtr(TriMeshPtr(), &mesh));                        // borrowed for this call
  if (progress) progress->stage(0.4, 0.9);
  spread_samples(surface, spacing, sweeps, samples, progress);
  if (progress) progress->stage(0.0, 1.0);
  assign_voronoi_areas(mesh, samples);
  return samples;
}

}  // namespace taxel
