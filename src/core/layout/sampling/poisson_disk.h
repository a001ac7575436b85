// Constrained Poisson-disk samples on a mesh (Corsini, Cignoni, Scopigno 2012), exact count, deterministic by seed.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// How much work goes into evenness.
enum class SampleQuality {
  preview,  ///< no two samples close together, all of equal area: a tenth of the time
  polished  ///< spread as evenly as possible, areas of the Voronoi cells
};
/// A stable word: "preview", "polished".
inline const char* to_string(SampleQuality quality) {
  return quality == SampleQuality::preview ? "preview" : "polished";
}

/// Exactly `count` samples spread over all faces of `mesh`. Same mesh, count, seed and quality: same bytes, on any
/// number of threads. Throws Error if count < 0 or above 10 million, Cancelled through `progress`, which goes
/// from 0.1 to 0.9.
std::vector<SurfaceSample> sample_surface(const TriMesh& mesh, int count, std::uint64_t seed,
                                          Progress* progress = nullptr,
                                          SampleQuality quality = SampleQuality::polished);

/// The most samples one surface may have.
inline constexpr int kMaxSamples = 10'000'000;

/// round(density * area). Throws Error when that is negative, not a number or above kMaxSamples.
int sample_count(double density, double area);

}  // namespace taxel
