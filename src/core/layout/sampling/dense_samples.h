// Parts of a surface with more samples than the rest.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/progress.h"
#include "core/layout/sampling/poisson_disk.h"

namespace taxel {

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
