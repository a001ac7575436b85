#include "core/sensor/explain/behind/polygons_behind.h"

#include <algorithm>

#include "core/base/index.h"

namespace taxel {
namespace {

PolygonBehind describe(const InvertedTets& inverted, const ContactSurface& surface, int s, int p) {
  const ContactPolygon& polygon = surface.polygons[at(p)];
  PolygonBehind row;
  row.surface = s, row.polygon = p;
  row.tet = polygon.tet, row.tet_b = polygon.tet_b, row.face = polygon.face;
  row.inverted = inverted.concern(polygon);
  row.area = polygon.area;
  row.mean = polygon.pressure;  // the mean of a linear pressure is its value at the centroid
  row.lowest = std::numeric_limits<double>::infinity();
  for (int i = polygon.first; i < polygon.first + polygon.count; ++i) {
    row.lowest = std::min(row.lowest, surface.pressure[at(i)]);
    row.highest = std::max(row.highest, surface.pressure[at(i)]);
  }
  return row;
}

void add_served(const SensorModel& model, const std::vector<RayHit>& hits, const std::vector<std::size_t>& first,
                std::vector<PolygonBehind>& rows) {
  for (int k = 0; k < model.taxel_count(); ++k) {
    const int id = model.layout.taxels[at(k)].id;
    for (int e = model.fields.first[at(k)]; e < model.fields.first[at(k) + 1]; ++e) {
      const RayHit& hit = hits[at(model.readout_table.ray_of_entry[at(e)])];
      if (!hit.hit()) continue;
      std::vector<int>& taxels = rows[first[at(hit.surface)] + at(hit.polygon)].taxels;
      if (taxels.empty() || taxels.back() != id) taxels.push_back(id);
    }
  }
  for (PolygonBehind& row : rows) {
    std::sort(row.taxels.begin(), row.taxels.end());
    row.taxels.erase(std::unique(row.taxels.begin(), row.taxels.end()), row.taxels.end());
  }
}

}  // namespace

std::vector<PolygonBehind> polygons_behind(const SensorModel& model, int taxel, const SensorStep& step,
                                           const std::vector<TaxelSampleReading>& behind, const ExactReading& exact,
                                           const InvertedTets& inverted) {
  std::vector<PolygonBehind> rows;
  std::vector<std::size_t> first;  // row of each surface's first polygon
  double pressed = 0;
  for (std::size_t s = 0; s < step.surfaces.size(); ++s) {
    first.push_back(rows.size());
    for (std::size_t p = 0; p < step.surfaces[s].polygons.size(); ++p) {
      rows.push_back(describe(inverted, step.surfaces[s], static_cast<int>(s), static_cast<int>(p)));
      pressed += rows.back().area * rows.back().mean;
    }
  }
  for (PolygonBehind& row : rows) row.force_share = pressed > 0 ? row.area * row.mean / pressed : 0.0;
  const int begin = model.fields.first[at(taxel)];
  for (std::size_t i = 0; i < behind.size(); ++i) {
    const RayHit& hit = step.hits[at(model.readout_table.ray_of_entry[at(begin) + i])];
    if (!hit.hit()) continue;
    PolygonBehind& row = rows[first[at(hit.surface)] + at(hit.polygon)];
    ++row.samples;
    row.share += behind[i].share;
  }
  if (exact.value && *exact.value > 0)
    for (const PolygonPart& part : exact.parts)
      rows[first[at(part.surface)] + at(part.polygon)].exact_share = part.value / *exact.value;
  add_served(model, step.hits, first, rows);
  return rows;
}

}  // namespace taxel
