// The rays of a sensor in tiles of neighbours, for polygons of which no tet says which rays may hit them.
//
// Rays are fixed in the sensor's frame, so the tiles and their tree are made once. A tree over the origins of the rays
// gives the tiles: its leaves. Each tile keeps the box of its rays, and a cylinder around their mean line, which is
// narrower than the box where rays are oblique to the axes. A polygon visits the tree with its box, and is tested
// against the rays of the tiles whose cylinders it reaches. So the cost of a step depends on the polygons and the rays
// near them, not on the number of rays, and no tree is built during a step.
//
// Pitfall: boxes and cylinders must include the reach of a polygon beyond its rim and the rounding of coordinates, or a
// hit would be lost. Theory: docs/theory/sensor.md, "Rays and readings".
#include "core/sensor/rays/ray_tiles.h"

#include <algorithm>
#include <limits>

namespace taxel {
namespace {

RayTiles::Group group_of(std::span<const SensorRay> rays, std::span<const std::int32_t> numbers) {
  std::vector<const SensorRay*> seen;
  for (const std::int32_t r : numbers) seen.push_back(&rays[static_cast<std::size_t>(r)]);
  const RayViewer viewer(seen);
  RayTiles::Group group{viewer.view(), {}, viewer.axis(), 0, viewer.tile_of(rays, numbers)};
  for (const SensorRay* ray : seen) group.origin += ray->origin / static_cast<double>(seen.size());
  for (const SensorRay* ray : seen) {
    for (const double depth : {0.0, ray->max_depth}) {  // the distance from a line is largest at an end
      const dvec3 x = ray->origin + depth * ray->direction - group.origin;
      group.reach = std::max(group.reach, glm::length(glm::cross(x, group.axis)));
    }
  }
  return group;
}

Aabb box_of(std::span<const SensorRay> rays, const RayTile& tile) {
  Aabb box;
  for (const std::int32_t r : tile.ray) {
    if (r < 0) continue;
    const SensorRay& ray = rays[static_cast<std::size_t>(r)];
    box.include(ray.origin);
    box.include(ray.origin + ray.max_depth * ray.direction);
  }
  return box;
}

}  // namespace

RayTiles::RayTiles(std::span<const SensorRay> rays) {
  std::vector<Aabb> boxes(rays.size());
  for (std::size_t r = 0; r < rays.size(); ++r) boxes[r].include(rays[r].origin);
  Bvh origins;
  origins.build(boxes, static_cast<int>(RayTile::kRays), Bvh::Effort::few_queries);
  boxes.clear();
  for (const Bvh::Node& node : origins.nodes()) {
    if (!node.leaf()) continue;
    const std::span items(origins.items().data() + node.first, static_cast<std::size_t>(node.count));
    groups_.push_back(group_of(rays, items));
    boxes.push_back(box_of(rays, groups_.back().tile));
  }
  tree_.build(boxes);
}

void RayTiles::find(const ContactSurface& surface, const ContactPolygon& polygon,
                    std::vector<std::int32_t>& found) const {
  found.clear();
  Aabb box;
  double radius = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec3& corner = surface.vertices[static_cast<std::size_t>(polygon.first + i)];
    box.include(corner);
    radius = std::max(radius, glm::distance(corner, polygon.centroid));
  }
  const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi)), e = box.extent();
  const double coordinates = largest.x + largest.y + largest.z;
  const double margin = 2.0 * rim_reach(coordinates, polygon.count * (e.x + e.y + e.z)) +
                        64.0 * std::numeric_limits<double>::epsilon() * coordinates;
  const Aabb near{box.lo - margin, box.hi + margin};
  tree_.visit([&](const Aabb& rays) { return rays.overlaps(near); },
              [&](std::int32_t number) {
                const Group& group = this->group(number);
                const dvec3 x = polygon.centroid - group.origin;
                const double reach = group.reach + radius + margin, along = glm::dot(x, group.axis);
                if (glm::dot(x, x) - along * along <= reach * reach) found.push_back(number);
              });
}

}  // namespace taxel
