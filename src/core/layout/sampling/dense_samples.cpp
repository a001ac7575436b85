// Each part is sampled in turn, the least dense first: a patch that is larger than the part is sampled densely, and
// replaces samples cell by cell.
//
//     |  o  |  o  |       o  usual samples and their Voronoi cells: these two keep place and area
//   --+-----+-----+--
//     |. . .|. . .|       .  samples of the patch that are in the cells of usual samples of the part: they take their
//     | . . | . . |          place, and share their area
//     |. . .|. . .|
//   --+-----+-----+--
//
// Samples of the patch in the other cells, its border, are thrown away: with them, those at the edge of the part are as
// evenly spread as those inside.
#include "core/layout/sampling/dense_samples.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/layout/sampling/dense_part.h"
#include "core/layout/sampling/sample_elimination.h"
#include "core/layout/sampling/sample_spread.h"
#include "core/layout/sampling/voronoi_area.h"

namespace taxel {
namespace {

/// Returns the number of samples that gives the inside of a patch the density of the part. Samples crowd at the edge of
/// a patch, where nothing pushes them back: measured, a quarter of a sample more per spacing of the edge.
int sample_count_of(const SurfacePool& pool, const DensePart& part, int per_sample) {
  constexpr double kAtEdge = 0.25;
  const double spacing = part.spacing(), per_area = part.density() * spacing * spacing;  // samples per spacing squared
  const auto in_strip = std::count_if(pool.positions.begin(), pool.positions.end(),
                                      [&](const dvec3& p) { return !part.is_within(p, -spacing); });
  const double edge = static_cast<double>(in_strip) / (per_sample * per_area);  // length of the edge, in spacings
  return static_cast<int>(std::round(pool.size() / double(per_sample) + kAtEdge * edge));
}

/// Samples a patch.
std::vector<SurfaceSample> sample_patch(const SurfaceGraph& surface, const PartSurface& near, const DensePart& part,
                                        const DenseSampling& how, Progress* progress) {
  const int per_sample = pool_factor(how.quality);
  const SurfacePool pool = part.pool(surface.mesh(), near, per_sample, how.seed);
  const int count = sample_count_of(pool, part, per_sample);
  std::vector<SurfaceSample> patch;
  if (count == 0) return patch;
  for (const int k : eliminate_samples(surface, pool, count, part.spacing(), progress))
    patch.push_back({pool.positions[at(k)], pool.normals[at(k)], pool.faces[at(k)]});
  if (how.quality == SampleQuality::polished)
    spread_samples(surface, part.spacing(), kSpreadSweeps, patch, progress,
                   [&](const dvec3& place) { return part.is_within(place, 0); });
  return patch;
}

/// Replaces the samples of one part by those of its patch.
void sample_part(const SurfaceGraph& surface, const DensePart& part, const DenseSampling& how,
                 std::vector<SurfaceSample>& samples, Progress* progress) {
  const double usual_spacing = 1 / std::sqrt(how.density);
  const PartSurface near = part.surface(surface.mesh());
  const std::vector<SurfaceSample> patch = sample_patch(surface, near, part, how, progress);
  const std::vector<int> cells = cells_of(patch, samples, usual_spacing);
  std::vector<bool> is_replaced;
  std::vector<SurfaceSample> dense, others;
  double area = 0;
  for (const SurfaceSample& s : samples) {
    is_replaced.push_back(part.has(s.position, s.normal));
    if (!is_replaced.back())
      others.push_back(s);
    else
      area += s.area;
  }
  for (std::size_t i = 0; i < patch.size(); ++i)
    if (is_replaced[at(cells[i])]) dense.push_back(patch[i]);
  if (dense.empty()) return;
  for (SurfaceSample& s : dense) s.area = area / static_cast<double>(dense.size());
  if (how.quality == SampleQuality::polished) {
    const TriMesh own = surface_of_cells(near.mesh, samples, is_replaced, usual_spacing);
    assign_voronoi_areas(own, dense);
    for (SurfaceSample& s : dense) s.area *= area / own.area();  // removes rounding errors
  }
  for (SurfaceSample& s : dense) s.share = how.density * s.area;
  samples = std::move(others);
  samples.insert(samples.end(), dense.begin(), dense.end());
}

}  // namespace

std::vector<SurfaceSample> add_dense_samples(const TriMesh& mesh, std::vector<SurfaceSample> samples,
                                             const DenseSampling& how, Progress* progress) {
  const std::vector<DensePart> parts = dense_parts(how.discs, how.density);
  if (parts.empty() || samples.empty()) return samples;
  const SurfaceGraph surface(mesh);
  for (const DensePart& part : parts) {
    sample_part(surface, part, how, samples, progress);
    if (samples.size() > static_cast<std::size_t>(kMaxSamples))
      throw Error(fmt::format("the densities of taxels give more than {} samples", kMaxSamples));
  }
  return samples;
}

}  // namespace taxel
