#include "core/layout/receptive_field.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/layout/point_grid.h"

namespace taxel {
namespace {

/// One disc that gathers samples: a taxel without subtaxels, or one subtaxel.
struct Disc {
  dvec3 center, normal;
  double radius;
};

std::vector<Disc> discs_of(const Taxel& taxel) {
  if (taxel.subtaxels.empty()) return {{taxel.center, glm::normalize(taxel.normal), taxel.radius}};
  std::vector<Disc> discs;
  for (const Subtaxel& s : taxel.subtaxels) discs.push_back({s.center, glm::normalize(s.normal), s.radius});
  return discs;
}

/// The union of the discs' fields; a sample in several belongs to the nearest of them.
std::vector<ReceptiveFields::Entry> gather(const Taxel& taxel, double min_cosine,
                                           const std::vector<SurfaceSample>& samples, const PointGrid& grid) {
  std::vector<ReceptiveFields::Entry> row;
  for (const Disc& disc : discs_of(taxel)) {
    grid.visit_near(disc.center, disc.radius, [&](int i) {
      const SurfaceSample& s = samples[static_cast<std::size_t>(i)];
      const double d = glm::distance(disc.center, s.position);
      if (d > disc.radius || !(glm::dot(s.normal, disc.normal) > min_cosine)) return;
      const double reach = disc.radius - d;
      row.push_back({i, d, reach * reach});  // w = (r - d)^2, the paper's weight
    });
  }
  std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) {
    return a.sample != b.sample ? a.sample < b.sample : a.distance < b.distance;
  });
  row.erase(std::unique(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.sample == b.sample; }),
            row.end());
  return row;
}

/// Cells a third of the smallest radius: few points outside of the ball are looked at, few cells are empty.
double cell_size(const Layout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Taxel& taxel : layout.taxels)
    for (const Disc& disc : discs_of(taxel)) smallest = std::min(smallest, disc.radius);
  return std::isfinite(smallest) && smallest > 0.0 ? smallest / 3.0 : 1.0;
}

}  // namespace

ReceptiveFields make_receptive_fields(const Layout& layout, const std::vector<SurfaceSample>& samples) {
  if (layout.receptive_field.metric == Metric::geodesic)
    throw Error("", "/receptive_field/metric", "\"geodesic\" is not available yet, use \"euclidean\"");
  const double min_cosine = std::cos(layout.receptive_field.max_angle_deg * kPi / 180.0);

  std::vector<dvec3> positions;
  positions.reserve(samples.size());
  double total_area = 0.0;
  for (const SurfaceSample& s : samples) {
    positions.push_back(s.position);
    total_area += s.area;
  }
  const PointGrid grid(positions, cell_size(layout));

  std::vector<std::vector<ReceptiveFields::Entry>> rows(layout.taxels.size());
  parallel_chunks(static_cast<int>(rows.size()), 8, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      rows[k] = gather(layout.taxels[k], min_cosine, samples, grid);
  });

  const double per_area = total_area > 0.0 ? static_cast<double>(samples.size()) / total_area : 0.0;
  ReceptiveFields fields;
  for (const auto& row : rows) {
    fields.entries.insert(fields.entries.end(), row.begin(), row.end());
    fields.first.push_back(static_cast<int>(fields.entries.size()));
  }
  if (layout.sampling.weights == SampleWeights::voronoi)
    for (ReceptiveFields::Entry& e : fields.entries)
      e.weight *= samples[static_cast<std::size_t>(e.sample)].area * per_area;  // area over the mean area
  return fields;
}

}  // namespace taxel
