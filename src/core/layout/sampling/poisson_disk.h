// Constrained Poisson-disk samples on a mesh (Corsini, Cignoni, Scopigno 2012), exact count, deterministic by seed, and
// parts of the surface with more samples than the rest.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/progress.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Quality of samples: the amount of work to make them even.
enum class SampleQuality {
  preview,  ///< no two samples close together, all of equal area: a tenth of the time
  polished  ///< spread as evenly as possible, areas of the Voronoi cells
};
/// Returns a stable word: "preview", "polished".
inline const char* to_string(SampleQuality quality) {
  return quality == SampleQuality::preview ? "preview" : "polished";
}

/// Returns the number of points of a pool from which one sample is chosen. Yuksel 2015, section 3: a pool of more than
/// 4 helps little. With 5 points and 5 sweeps every mesh of the tests is as even as they ask for; neither a pool of 8
/// nor eight sweeps makes the readings of a sliding finger any smoother.
inline constexpr int pool_factor(SampleQuality quality) {
  return quality == SampleQuality::polished ? 5 : 3;
}
inline constexpr int kSpreadSweeps = 5;

/// Returns exactly `count` samples spread over all faces of `mesh`. The same mesh, count, seed and quality give the
/// same bytes, on any number of threads. Throws Error if count < 0 or above 10 million, Cancelled through `progress`,
/// which goes from 0.1 to 0.9.
std::vector<SurfaceSample> sample_surface(const TriMesh& mesh, int count, std::uint64_t seed,
                                          Progress* progress = nullptr,
                                          SampleQuality quality = SampleQuality::polished);

/// Largest number of samples on one surface.
inline constexpr int kMaxSamples = 10'000'000;

/// Returns round(density * area). Throws Error if this is negative, not a number or above kMaxSamples.
int sample_count(double density, double area);

/// A ball whose part of a surface has its own density of samples.
struct DenseDisc {
  dvec3 center{0};          ///< [m]
  dvec3 normal{0, 0, 1};    ///< unit normal
  double radius = 0;        ///< [m]
  double least_cosine = 0;  ///< least cosine between `normal` and that of a face in the part
  double density = 0;       ///< samples per m^2
  bool operator==(const DenseDisc&) const = default;
};

/// How a surface is sampled more densely.
struct DenseSampling {
  double density = 0;            ///< samples per m^2 outside of the discs
  std::vector<DenseDisc> discs;  ///< discs that are not denser are left out
  std::uint64_t seed = 0;
  SampleQuality quality{};
  bool operator==(const DenseSampling&) const = default;
};

/// Replaces samples of sample_surface() by denser ones where `how.discs` are: all samples whose Voronoi cells reach
/// into a disc. Where discs overlap, the densest counts. The other samples keep their bits and their order, and come
/// first. The new ones fill the cells of those that they replace, as far apart and as evenly as on a surface of their
/// density, and represent the same area in all: if polished, SurfaceSample::area is that of a Voronoi cell within the
/// replaced cells. SurfaceSample::share is the usual density times this area.
///
/// The result depends on the arguments only, with the same bytes on any number of threads. Discs that are more than
/// twice DensePart::patch_reach() apart do not depend on each other. Throws Error above kMaxSamples samples, and throws
/// Cancelled.
std::vector<SurfaceSample> add_dense_samples(const TriMesh& mesh, std::vector<SurfaceSample> samples,
                                             const DenseSampling& how, Progress* progress = nullptr);

}  // namespace taxel
