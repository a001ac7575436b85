#include "core/sensor/tet_table.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"

namespace taxel {
namespace {

/// A ray in a tet.
struct Crossing {
  std::int32_t tet = 0, ray = 0;
  double t_min = 0, t_max = 0;
};

/// Finds the tets that rays cross.
class Crossings {
 public:
  explicit Crossings(const PressureField& field) : field_(field), tree_(tree_of_tets(field)) {
    const Aabb& box = field.bounds();
    const dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    coordinates_ = largest.x + largest.y + largest.z;
    for (const Tet& tet : field.tets()) widest_ = std::max(widest_, width(tet));
  }

  /// Adds what `ray` crosses, tets ascending.
  void find(std::int32_t number, const SensorRay& ray, std::vector<Crossing>& out) const {
    const SlabTest slabs(Ray{ray.origin, ray.direction});
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    tree_.visit(
        [&](const Aabb& box) {
          return slabs.entry({box.lo - widest_, box.hi + widest_}, ray.max_depth) < SlabTest::kMiss;
        },
        [&](int tet) { add(tet, number, ray, out); });
    std::sort(out.begin() + before, out.end(), [](const Crossing& a, const Crossing& b) { return a.tet < b.tet; });
  }

 private:
  /// How far outside of the tet a hit on one of its polygons may lie: vertices move by less than 1e-6 of its size when
  /// they are merged, and rim_reach() of a polygon in it is less than 1e-8 of its coordinates.
  [[nodiscard]] double width(const Tet& tet) const { return 2e-6 * tet.size + 1e-8 * coordinates_; }

  /// Clips the ray with the four planes.
  void add(int number, std::int32_t ray_number, const SensorRay& ray, std::vector<Crossing>& out) const {
    const Tet& tet = field_.tets()[static_cast<std::size_t>(number)];
    double t_min = 0, t_max = ray.max_depth;
    for (std::size_t i = 0; i < 4; ++i) {
      const double rate = glm::dot(tet.normal[i], ray.direction);
      const double start = glm::dot(tet.normal[i], ray.origin) + tet.offset[i] + width(tet);
      if (rate > 0) t_min = std::max(t_min, -start / rate);
      if (rate < 0) t_max = std::min(t_max, -start / rate);
      if (rate == 0 && start < 0) return;
    }
    if (t_min <= t_max) out.push_back({number, ray_number, t_min, t_max});
  }

  const PressureField& field_;
  Bvh tree_;
  double coordinates_ = 0, widest_ = 0;
};

RayBlock empty_block() {
  RayBlock block;
  for (auto* values : {&block.ox, &block.oy, &block.oz, &block.dx, &block.dy, &block.dz, &block.t_min}) values->fill(0);
  block.t_max.fill(-1);  // before t_min: never met
  block.ray.fill(0);
  return block;
}

void append(RayBlock& block, const Crossing& crossing, const SensorRay& ray) {
  const auto i = static_cast<std::size_t>(block.count++);
  block.ox[i] = ray.origin.x, block.oy[i] = ray.origin.y, block.oz[i] = ray.origin.z;
  block.dx[i] = ray.direction.x, block.dy[i] = ray.direction.y, block.dz[i] = ray.direction.z;
  block.t_min[i] = crossing.t_min, block.t_max[i] = crossing.t_max;
  block.ray[i] = crossing.ray;
}

}  // namespace

TetTable::TetTable(const PressureField& field, std::span<const SensorRay> rays) {
  constexpr int kChunk = 512;
  const Crossings crossings(field);
  const int count = static_cast<int>(rays.size());
  std::vector<std::vector<Crossing>> found(rays.size() / kChunk + 1);
  parallel_chunks(count, kChunk, [&](int begin, int end) {
    for (int r = begin; r < end; ++r)
      crossings.find(r, rays[static_cast<std::size_t>(r)], found[static_cast<std::size_t>(begin / kChunk)]);
  });

  std::vector<std::size_t> rays_of(field.tets().size(), 0);
  for (const auto& chunk : found)
    for (const Crossing& c : chunk) ++rays_of[static_cast<std::size_t>(c.tet)];
  for (const std::size_t n : rays_of) first_.push_back(first_.back() + (n + RayBlock::kRays - 1) / RayBlock::kRays);
  blocks_.assign(first_.back(), empty_block());
  std::vector<std::size_t> filling(first_.begin(), first_.end() - 1);
  for (const auto& chunk : found) {
    for (const Crossing& c : chunk) {
      std::size_t& block = filling[static_cast<std::size_t>(c.tet)];
      if (blocks_[block].count == static_cast<std::int32_t>(RayBlock::kRays)) ++block;
      append(blocks_[block], c, rays[static_cast<std::size_t>(c.ray)]);
    }
  }
}

}  // namespace taxel
