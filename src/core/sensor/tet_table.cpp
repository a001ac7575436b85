#include "core/sensor/tet_table.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"

namespace taxel {
namespace {

RayBlock empty_block() {
  RayBlock block;
  for (auto* values : {&block.ox, &block.oy, &block.oz, &block.dx, &block.dy, &block.dz, &block.t_min}) values->fill(0);
  block.t_max.fill(-1);  // before t_min: never met
  block.ray.fill(0);
  return block;
}

void append(RayBlock& block, const TetCrossing& crossing, std::size_t number, const SensorRay& ray) {
  const auto i = static_cast<std::size_t>(block.count++);
  block.ox[i] = ray.origin.x, block.oy[i] = ray.origin.y, block.oz[i] = ray.origin.z;
  block.dx[i] = ray.direction.x, block.dy[i] = ray.direction.y, block.dz[i] = ray.direction.z;
  block.t_min[i] = crossing.t_min, block.t_max[i] = crossing.t_max;
  block.ray[i] = static_cast<std::int32_t>(number);
}

}  // namespace

TetTable::TetTable(const PressureField& field, std::span<const SensorRay> rays) {
  const TetCrossings tets(field);
  std::vector<std::vector<TetCrossing>> found(rays.size());
  parallel_chunks(static_cast<int>(rays.size()), 512, [&](int begin, int end) {
    for (auto r = static_cast<std::size_t>(begin); r < static_cast<std::size_t>(end); ++r) tets.find(rays[r], found[r]);
  });
  fill(field.tets().size(), rays, std::vector<std::span<const TetCrossing>>(found.begin(), found.end()));
}

void TetTable::fill(std::size_t tets, std::span<const SensorRay> rays,
                    std::span<const std::span<const TetCrossing>> crossings) {
  std::vector<std::size_t> rays_of(tets, 0);
  for (const auto& of_ray : crossings)
    for (const TetCrossing& c : of_ray) ++rays_of[static_cast<std::size_t>(c.tet)];
  for (const std::size_t n : rays_of) first_.push_back(first_.back() + (n + RayBlock::kRays - 1) / RayBlock::kRays);
  blocks_.assign(first_.back(), empty_block());
  std::vector<std::size_t> filling(first_.begin(), first_.end() - 1);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    for (const TetCrossing& c : crossings[r]) {
      std::size_t& block = filling[static_cast<std::size_t>(c.tet)];
      if (blocks_[block].count == static_cast<std::int32_t>(RayBlock::kRays)) ++block;
      append(blocks_[block], c, r, rays[r]);
    }
  }
}

}  // namespace taxel
