// For each tet of a sensor's pressure field, the rays that cross it.
//
// Rays and tets are fixed in the sensor's frame, and each contact polygon lies in one tet. So the search for the rays
// that may hit a polygon is done once, when the sensor is compiled: a ray visits the boxes of a tree over the tets and
// is clipped by the four planes of each tet there. Lists are then turned around by counting, and the rays of a tet are
// stored in tiles of one vector with their places in the view along their mean direction.
//
// Pitfall: a hit may be a little outside of the polygon's tet, by merged vertices (1e-6 of its size) and by the rim of
// a polygon. Tets are enlarged by more than that, so that the table misses no hit. Cost of a step: the rays of each
// polygon's tet. Theory: docs/theory/sensor.md, "Rays and readings".
#include "core/sensor/rays/tet_table.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace taxel {

TetCrossings::TetCrossings(const PressureField& field) : field_(field), tree_(tree_of_tets(field)) {
  const Aabb& box = field.bounds();
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  coordinates_ = largest.x + largest.y + largest.z;
  for (const Tet& tet : field.tets()) widest_ = std::max(widest_, width(tet));
}

void TetCrossings::find(const SensorRay& ray, std::vector<std::int32_t>& found) const {
  const SlabTest slabs(Ray{ray.origin, ray.direction});
  found.clear();
  tree_.visit(
      [&](const Aabb& box) {
        return slabs.entry({box.lo - widest_, box.hi + widest_}, ray.max_depth) < SlabTest::kMiss;
      },
      [&](int tet) {
        if (crosses(tet, ray)) found.push_back(tet);
      });
  std::sort(found.begin(), found.end());
}

/// Returns the largest distance outside of a tet of a hit on one of its polygons. Merged vertices move by less than
/// 1e-6 of the tet's size, and rim_reach() of its polygons is less than 1e-8 of the coordinates.
double TetCrossings::width(const Tet& tet) const {
  return 2e-6 * tet.size + 1e-8 * coordinates_;
}

/// Clips the ray by the four planes.
bool TetCrossings::crosses(int number, const SensorRay& ray) const {
  const Tet& tet = field_.tets()[static_cast<std::size_t>(number)];
  double t_min = 0, t_max = ray.max_depth;
  for (std::size_t i = 0; i < 4; ++i) {
    const double rate = glm::dot(tet.normal[i], ray.direction);
    const double start = glm::dot(tet.normal[i], ray.origin) + tet.offset[i] + width(tet);
    if (rate > 0) t_min = std::max(t_min, -start / rate);
    if (rate < 0) t_max = std::min(t_max, -start / rate);
    if (rate == 0 && start < 0) return false;
  }
  return t_min <= t_max;
}

TetTable::TetTable(const PressureField& field, std::span<const SensorRay> rays) {
  const TetCrossings tets(field);
  std::vector<std::vector<std::int32_t>> found(rays.size());
  parallel_chunks(static_cast<int>(rays.size()), 512, [&](int begin, int end) {
    for (auto r = static_cast<std::size_t>(begin); r < static_cast<std::size_t>(end); ++r) tets.find(rays[r], found[r]);
  });
  fill(field.tets().size(), rays, std::vector<std::span<const std::int32_t>>(found.begin(), found.end()));
}

void TetTable::fill(std::size_t tets, std::span<const SensorRay> rays,
                    std::span<const std::span<const std::int32_t>> crossings) {
  std::vector<std::uint32_t> first(tets + 1, 0);
  for (const auto& of_ray : crossings)
    for (const std::int32_t tet : of_ray) ++first[static_cast<std::size_t>(tet) + 1];
  tets_.assign(tets, TetRays{});
  std::uint32_t tiles = 0;
  for (std::size_t t = 0; t < tets; ++t) {
    tets_[t].first_tile = tiles;
    tets_[t].tiles = (first[t + 1] + RayTile::kRays - 1) / RayTile::kRays;
    tiles += tets_[t].tiles;
    first[t + 1] += first[t];
  }
  tiles_.resize(tiles);
  std::vector<std::uint32_t> filling(first.begin(), first.end() - 1);
  std::vector<std::int32_t> crossing(first.back());
  for (std::size_t r = 0; r < rays.size(); ++r) {
    for (const std::int32_t tet : crossings[r])
      crossing[filling[static_cast<std::size_t>(tet)]++] = static_cast<std::int32_t>(r);
  }
  parallel_chunks(static_cast<int>(tets), 512, [&](int begin, int end) {
    for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      set(t, rays, std::span(crossing).subspan(first[t], first[t + 1] - first[t]));
  });
}

void TetTable::set(std::size_t tet, std::span<const SensorRay> rays, std::span<const std::int32_t> crossing) {
  if (crossing.empty()) return;
  std::vector<const SensorRay*> seen;
  for (const std::int32_t r : crossing) seen.push_back(&rays[static_cast<std::size_t>(r)]);
  const RayViewer viewer(seen);
  TetRays& of_tet = tets_[tet];
  of_tet.view = viewer.view();
  for (std::size_t i = 0; i < of_tet.tiles; ++i) {
    const std::size_t first = i * RayTile::kRays;
    tiles_[of_tet.first_tile + i] =
        viewer.tile_of(rays, crossing.subspan(first, std::min(RayTile::kRays, crossing.size() - first)));
  }
}

}  // namespace taxel
