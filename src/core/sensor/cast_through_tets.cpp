// Contact polygons against the rays of their tets, as many at a time as the machine has lanes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sensor/cast_through_tets.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <bit>

#include "core/sensor/tet_table.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Rays = hn::CappedTag<double, RayBlock::kRays>;
using Lanes = hn::Vec<Rays>;

struct Lanes3 {
  Lanes x, y, z;
};

HWY_INLINE Lanes3 broadcast(const dvec3& v) {
  const Rays d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// In the order of glm::dot, without fused multiply-add: the same bits on every machine, and as hit_polygon().
HWY_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// hit_polygon() for the rays of a block from lane `first` on: bit i, lane first + i.
class PolygonTest {
 public:
  PolygonTest(const ContactPolygon& polygon, const EdgePlane* planes)
      : normal_(broadcast(polygon.normal)),
        centroid_(broadcast(polygon.centroid)),
        gradient_(broadcast(polygon.gradient)),
        pressure_(polygon.pressure),
        planes_(planes),
        count_(polygon.count) {}

  HWY_INLINE unsigned operator()(const RayBlock& block, std::size_t first, double* HWY_RESTRICT depth,
                                 double* HWY_RESTRICT pressure) const {
    const Rays d;
    const Lanes3 w{hn::Sub(hn::Load(d, &block.ox[first]), centroid_.x),
                   hn::Sub(hn::Load(d, &block.oy[first]), centroid_.y),
                   hn::Sub(hn::Load(d, &block.oz[first]), centroid_.z)};
    const Lanes3 direction{hn::Load(d, &block.dx[first]), hn::Load(d, &block.dy[first]), hn::Load(d, &block.dz[first])};
    const Lanes t = hn::Div(hn::Neg(dot(normal_, w)), dot(normal_, direction));
    auto inside = hn::And(hn::Ge(t, hn::Load(d, &block.t_min[first])), hn::Le(t, hn::Load(d, &block.t_max[first])));
    if (hn::AllFalse(d, inside)) return 0;
    const Lanes3 y{hn::Add(w.x, hn::Mul(t, direction.x)), hn::Add(w.y, hn::Mul(t, direction.y)),
                   hn::Add(w.z, hn::Mul(t, direction.z))};
    for (int k = 0; k < count_; ++k) {
      const Lanes side = hn::Add(dot(broadcast(planes_[k].m), y), hn::Set(d, planes_[k].c));
      inside = hn::And(inside, hn::Ge(side, hn::Zero(d)));
    }
    if (hn::AllFalse(d, inside)) return 0;
    hn::Store(t, d, depth);
    hn::Store(hn::Max(hn::Add(hn::Set(d, pressure_), dot(gradient_, y)), hn::Zero(d)), d, pressure);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, inside, bits);
    return bits[0];
  }

 private:
  Lanes3 normal_, centroid_, gradient_;
  double pressure_;
  const EdgePlane* planes_;
  int count_;
};

void run_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number,
                      std::vector<EdgePlane>& planes, RayHits& hits) {
  const std::size_t lanes = hn::Lanes(Rays());
  alignas(64) double depth[RayBlock::kRays], pressure[RayBlock::kRays];
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    const ContactPolygon& polygon = surface.polygons[p];
    const std::span<const RayBlock> blocks = table.blocks(polygon.tet);
    if (blocks.empty()) continue;
    if (planes.size() < static_cast<std::size_t>(polygon.count)) planes.resize(static_cast<std::size_t>(polygon.count));
    fill_edge_planes(surface, polygon, planes.data());
    const PolygonTest test(polygon, planes.data());
    for (const RayBlock& block : blocks) {
      for (std::size_t first = 0; first < static_cast<std::size_t>(block.count); first += lanes) {
        for (unsigned found = test(block, first, depth, pressure); found != 0; found &= found - 1) {
          const auto i = static_cast<std::size_t>(std::countr_zero(found));
          hits.offer(block.ray[first + i], {surface_number, static_cast<int>(p), depth[i], pressure[i]});
        }
      }
    }
  }
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_through_tets);

void cast_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number,
                       std::vector<EdgePlane>& planes, RayHits& hits) {
  HWY_DYNAMIC_DISPATCH(run_through_tets)(table, surface, surface_number, planes, hits);
}
}  // namespace taxel
#endif
