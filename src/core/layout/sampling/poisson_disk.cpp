#include "core/layout/sampling/poisson_disk.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/layout/sampling/sample_elimination.h"
#include "core/layout/sampling/sample_spread.h"
#include "core/layout/sampling/voronoi_area.h"

namespace taxel {
int sample_count(double density, double area) {
  const double count = std::round(density * area);
  if (!(count >= 0.0 && count <= kMaxSamples))
    throw Error(fmt::format("density {} per square metre on {} square metres gives {} samples, the limit is {}",
                            density, area, count, kMaxSamples));
  return static_cast<int>(count);
}

std::vector<SurfaceSample> sample_surface(const TriMesh& mesh, int count, std::uint64_t seed, Progress* progress,
                                          SampleQuality quality) {
  if (count < 0 || count > kMaxSamples)
    throw Error(fmt::format("{} samples asked for, the limits are 0 and {}", count, kMaxSamples));
  if (count == 0) return {};
  const bool polished = quality == SampleQuality::polished;
  // Yuksel 2015, section 3: a pool of more than 4 helps little. With 5 and 5 every mesh of the tests is as even as they
  // ask for; neither a pool of 8 nor eight sweeps makes the readings of a sliding finger any smoother.
  const int pool_factor = polished ? 5 : 3;
  const int sweeps = 5;
  const SurfacePool pool = make_surface_pool(mesh, pool_factor * count, seed);
  const SurfaceGraph surface(mesh);
  if (progress) progress->stage(0.1, polished ? 0.3 : 0.9);  // about their parts of the time
  const std::vector<int> kept = eliminate_samples(surface, pool, count, progress);

  std::vector<SurfaceSample> samples;
  samples.reserve(kept.size());
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    samples.push_back({pool.positions[i], pool.normals[i], pool.faces[i], mesh.area() / count});
  }
  if (polished) {
    const double spacing = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * count));  // spacing of the hexagonal packing
    if (progress) progress->stage(0.3, 0.9);
    spread_samples(surface, spacing, sweeps, samples, progress);
    assign_voronoi_areas(mesh, samples);
  }
  if (progress) progress->stage(0.0, 1.0);
  return samples;
}

}  // namespace taxel
