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
  const SurfacePool pool = make_surface_pool(mesh, pool_factor(quality) * count, seed);
  const SurfaceGraph surface(mesh);
  constexpr double kBegin = 0.1, kPolish = 0.3, kEnd = 0.9;                            // about their parts of the time
  const double reach = 2.0 * std::sqrt(mesh.area() / (2.0 * std::sqrt(3.0) * count));  // of the hexagonal packing
  const std::vector<int> kept = [&] {
    const ProgressPart part(progress, kBegin, polished ? kPolish : kEnd);
    return eliminate_samples(surface, pool, count, reach, progress);
  }();

  std::vector<SurfaceSample> samples;
  samples.reserve(kept.size());
  for (const int k : kept) {
    const auto i = static_cast<std::size_t>(k);
    samples.push_back({pool.positions[i], pool.normals[i], pool.faces[i], mesh.area() / count});
  }
  if (polished) {
    const double spacing = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * count));  // spacing of the hexagonal packing
    const ProgressPart part(progress, kPolish, kEnd);
    spread_samples(surface, spacing, kSpreadSweeps, samples, progress);
    assign_voronoi_areas(mesh, samples);
  }
  return samples;
}

}  // namespace taxel
