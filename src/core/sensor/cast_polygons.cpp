// Contact polygons against the rays listed for them, by tet or by cell, as many at a time as the machine has lanes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sensor/cast_polygons.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "core/sensor/ray_grid.h"
#include "core/sensor/tet_table.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::CappedTag<double, RayBlock::kRays>;
using Lanes = hn::Vec<Wide>;

struct Lanes3 {
  Lanes x, y, z;
};

HWY_INLINE Lanes3 broadcast(const dvec3& v) {
  const Wide d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// In the order of glm::dot, without fused multiply-add: the same bits on every machine, and as hit_polygon().
HWY_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// hit_polygon() in two parts: the plane against as many rays as there are lanes; then, for each ray that meets it, as
/// many edges as there are lanes. The edges are made ready when a ray asks for them.
class PolygonTest {
 public:
  PolygonTest(const ContactSurface& surface, const ContactPolygon& polygon, EdgeLanes& edges)
      : surface_(surface),
        polygon_(polygon),
        edges_(edges),
        normal_(broadcast(polygon.normal)),
        centroid_(broadcast(polygon.centroid)) {}

  /// Offers the hits of the rays [first, last), and of some behind them: rays as well, or lanes that meet nothing.
  HWY_INLINE void offer(const RayLanes& rays, std::size_t first, std::size_t last, RayHit hit, RayHits& hits) {
    const Wide d;
    alignas(64) double t[RayBlock::kRays] = {}, x[RayBlock::kRays] = {}, y[RayBlock::kRays] = {},
                       z[RayBlock::kRays] = {};
    for (; first < last; first += hn::Lanes(d)) {
      for (unsigned met = meet_plane(rays, first, t, x, y, z); met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        const dvec3 from_centroid(x[i], y[i], z[i]);
        if (!inside(from_centroid)) continue;
        hit.depth = t[i];
        hit.pressure = std::max(0.0, polygon_.pressure + glm::dot(polygon_.gradient, from_centroid));
        hits.offer(rays.ray[first + i], hit);
      }
    }
  }

 private:
  /// Bit i: lane first + i meets the plane within its range, and within the polygon's circle about its
  /// centroid. Distance, and point from the centroid.
  HWY_INLINE unsigned meet_plane(const RayLanes& rays, std::size_t first, double* HWY_RESTRICT distance,
                                 double* HWY_RESTRICT x, double* HWY_RESTRICT y, double* HWY_RESTRICT z) {
    const Wide d;
    const Lanes3 w{hn::Sub(hn::LoadU(d, rays.ox + first), centroid_.x),
                   hn::Sub(hn::LoadU(d, rays.oy + first), centroid_.y),
                   hn::Sub(hn::LoadU(d, rays.oz + first), centroid_.z)};
    const Lanes3 direction{hn::LoadU(d, rays.dx + first), hn::LoadU(d, rays.dy + first), hn::LoadU(d, rays.dz + first)};
    const Lanes t = hn::Div(hn::Neg(dot(normal_, w)), dot(normal_, direction));
    auto met = hn::And(hn::Ge(t, hn::LoadU(d, rays.t_min + first)), hn::Le(t, hn::LoadU(d, rays.t_max + first)));
    if (hn::AllFalse(d, met)) return 0;
    if (!ready_) make_ready();
    const Lanes3 at{hn::Add(w.x, hn::Mul(t, direction.x)), hn::Add(w.y, hn::Mul(t, direction.y)),
                    hn::Add(w.z, hn::Mul(t, direction.z))};
    met = hn::And(met, hn::Le(dot(at, at), hn::Set(d, circle_)));
    if (hn::AllFalse(d, met)) return 0;
    hn::Store(t, d, distance);
    hn::Store(at.x, d, x);
    hn::Store(at.y, d, y);
    hn::Store(at.z, d, z);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, met, bits);
    return bits[0];
  }

  [[nodiscard]] HWY_INLINE bool inside(const dvec3& from_centroid) const {
    const Wide d;
    const Lanes3 y = broadcast(from_centroid);
    for (std::size_t g = 0; g * EdgeLanes::kEdges < static_cast<std::size_t>(polygon_.count); ++g) {
      const EdgeLanes::Group& group = edges_.groups[g];
      for (std::size_t i = 0; i < EdgeLanes::kEdges; i += hn::Lanes(d)) {
        const Lanes3 m{hn::Load(d, &group.mx[i]), hn::Load(d, &group.my[i]), hn::Load(d, &group.mz[i])};
        const Lanes side = hn::Add(dot(m, y), hn::Load(d, &group.c[i]));
        if (!hn::AllTrue(d, hn::Ge(side, hn::Zero(d)))) return false;
      }
    }
    return true;
  }

  /// Corners from number `first` on, as many as there are lanes; what lies beyond the last one is anything.
  static HWY_INLINE Lanes3 load_corners(const dvec3* corners, std::size_t first) {
    Lanes3 v;
    hn::LoadInterleaved3(Wide(), &corners[first].x, v.x, v.y, v.z);
    return v;
  }

  /// The polygon's corners with room behind them to load whole vectors.
  const dvec3* corners() {
    const auto first = static_cast<std::size_t>(polygon_.first), count = static_cast<std::size_t>(polygon_.count);
    const dvec3* corner = surface_.vertices.data() + first;
    if (first + count + EdgeLanes::kEdges < surface_.vertices.size()) return corner;
    edges_.corners.resize(count + EdgeLanes::kEdges + 1);
    std::copy_n(corner, count, edges_.corners.begin());
    return edges_.corners.data();
  }

  /// fill_edge_planes(), in its order of operations.
  void make_ready() {
    const Wide d;
    const auto count = static_cast<std::size_t>(polygon_.count);
    const dvec3* corner = corners();
    const Lanes3 first_corner = broadcast(corner[0]);
    edges_.groups.resize(std::max(edges_.groups.size(), (count + EdgeLanes::kEdges - 1) / EdgeLanes::kEdges));
    Lanes longest = hn::Zero(d), farthest = hn::Zero(d);
    for (std::size_t k = 0; k < edges_.groups.size() * EdgeLanes::kEdges; k += hn::Lanes(d)) {
      EdgeLanes::Group& group = edges_.groups[k / EdgeLanes::kEdges];
      const std::size_t i = k % EdgeLanes::kEdges;
      if (k >= count) {
        for (auto* values : {&group.mx, &group.my, &group.mz, &group.c}) hn::Store(hn::Zero(d), d, &(*values)[i]);
        continue;
      }
      const auto used = hn::FirstN(d, count - k);
      const auto wraps = hn::AndNot(hn::FirstN(d, count - k - 1), used);
      const Lanes3 a = load_corners(corner, k), next = load_corners(corner, k + 1);
      const auto edge = [&](Lanes from, Lanes to, Lanes around) {
        return hn::IfThenElseZero(used, hn::Sub(hn::IfThenElse(wraps, around, to), from));
      };
      const Lanes3 e{edge(a.x, next.x, first_corner.x), edge(a.y, next.y, first_corner.y),
                     edge(a.z, next.z, first_corner.z)};
      const Lanes3 size{hn::Abs(e.x), hn::Abs(e.y), hn::Abs(e.z)};
      longest = hn::Max(longest, hn::Add(hn::Add(size.x, size.y), size.z));
      const Lanes3 m{hn::Sub(hn::Mul(normal_.y, e.z), hn::Mul(e.y, normal_.z)),
                     hn::Sub(hn::Mul(normal_.z, e.x), hn::Mul(e.z, normal_.x)),
                     hn::Sub(hn::Mul(normal_.x, e.y), hn::Mul(e.x, normal_.y))};
      const Lanes3 inward{hn::Sub(centroid_.x, a.x), hn::Sub(centroid_.y, a.y), hn::Sub(centroid_.z, a.z)};
      hn::Store(hn::Max(hn::Max(size.x, size.y), size.z), d, &group.length[i]);
      hn::Store(m.x, d, &group.mx[i]);
      hn::Store(m.y, d, &group.my[i]);
      hn::Store(m.z, d, &group.mz[i]);
      hn::Store(hn::IfThenElseZero(used, dot(m, inward)), d, &group.c[i]);
      farthest = hn::Max(farthest, hn::IfThenElseZero(used, dot(inward, inward)));
    }
    const double longest_edge = hn::GetLane(hn::MaxOfLanes(d, longest));
    shift_outward(hn::Set(d, edge_shift(polygon_, longest_edge)));
    // (r + reach)^2 <= (1 + 1e-4) r^2 + (1 + 1e4) reach^2: only rays outside for certain are left out.
    const double reach = polygon_reach(polygon_, longest_edge);
    circle_ = 1.0002 * hn::GetLane(hn::MaxOfLanes(d, farthest)) + 1.1e4 * reach * reach;
    ready_ = true;
  }

  HWY_INLINE void shift_outward(Lanes s) {
    const Wide d;
    for (std::size_t k = 0; k < static_cast<std::size_t>(polygon_.count); k += hn::Lanes(d)) {
      EdgeLanes::Group& group = edges_.groups[k / EdgeLanes::kEdges];
      const std::size_t i = k % EdgeLanes::kEdges;
      hn::Store(hn::Add(hn::Load(d, &group.c[i]), hn::Mul(s, hn::Load(d, &group.length[i]))), d, &group.c[i]);
    }
  }

  const ContactSurface& surface_;
  const ContactPolygon& polygon_;
  EdgeLanes& edges_;
  Lanes3 normal_, centroid_;
  bool ready_ = false;
  double circle_ = 0;  // squared radius that holds the polygon and what reaches over its rim [m^2]
};

RayLanes lanes_of(const RayBlock& b) {
  return {b.ox.data(), b.oy.data(),    b.oz.data(),    b.dx.data(), b.dy.data(),
          b.dz.data(), b.t_min.data(), b.t_max.data(), b.ray.data()};
}

bool run_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                      RayHits& hits) {
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    const ContactPolygon& polygon = surface.polygons[p];
    if (!table.has(polygon.tet)) return false;
    const std::span<const RayBlock> blocks = table.blocks(polygon.tet);
    if (blocks.empty()) continue;
    PolygonTest test(surface, polygon, edges);
    for (const RayBlock& block : blocks)
      test.offer(lanes_of(block), 0, static_cast<std::size_t>(block.count), {surface_number, static_cast<int>(p), 0, 0},
                 hits);
  }
  return true;
}

void run_through_grid(const RayGrid& grid, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                      RayHits& hits) {
  const RayLanes rays = grid.lanes();
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    PolygonTest test(surface, surface.polygons[p], edges);
    grid.visit(surface, surface.polygons[p], [&](std::size_t first, std::size_t last) {
      test.offer(rays, first, last, {surface_number, static_cast<int>(p), 0, 0}, hits);
    });
  }
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_through_tets);
HWY_EXPORT(run_through_grid);

bool cast_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                       RayHits& hits) {
  return HWY_DYNAMIC_DISPATCH(run_through_tets)(table, surface, surface_number, edges, hits);
}

void cast_through_grid(const RayGrid& grid, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                       RayHits& hits) {
  HWY_DYNAMIC_DISPATCH(run_through_grid)(grid, surface, surface_number, edges, hits);
}
}  // namespace taxel
#endif
