// Contact polygons against the rays listed for them, by tet or by cell, as many at a time as the machine has lanes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sensor/cast_polygons.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/sensor/ray_grid.h"
#include "core/sensor/tet_table.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::CappedTag<double, RayList::kPadding>;
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
  HWY_INLINE PolygonTest(const ContactSurface& surface, const ContactPolygon& polygon, EdgeLanes& edges)
      : surface_(surface),
        polygon_(polygon),
        edges_(edges),
        normal_(broadcast(polygon.normal)),
        centroid_(broadcast(polygon.centroid)),
        corners_(corners()),
        circle_(find_circle()) {}

  /// Offers the hits of the rays [first, last).
  HWY_INLINE void offer(const RayLanes& rays, std::size_t first, std::size_t last, RayHit hit, RayHits& hits) {
    const Wide d;
    alignas(64) double t[RayList::kPadding] = {}, x[RayList::kPadding] = {}, y[RayList::kPadding] = {},
                       z[RayList::kPadding] = {};
    for (; first < last; first += hn::Lanes(d)) {
      for (unsigned met = meet_plane(rays, first, last - first, t, x, y, z); met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        const dvec3 from_centroid(x[i], y[i], z[i]);
        if (!ready_) make_ready();
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
  HWY_INLINE unsigned meet_plane(const RayLanes& rays, std::size_t first, std::size_t count,
                                 double* HWY_RESTRICT distance, double* HWY_RESTRICT x, double* HWY_RESTRICT y,
                                 double* HWY_RESTRICT z) {
    const Wide d;
    const Lanes3 w{hn::Sub(hn::LoadU(d, rays.ox + first), centroid_.x),
                   hn::Sub(hn::LoadU(d, rays.oy + first), centroid_.y),
                   hn::Sub(hn::LoadU(d, rays.oz + first), centroid_.z)};
    const Lanes3 direction{hn::LoadU(d, rays.dx + first), hn::LoadU(d, rays.dy + first), hn::LoadU(d, rays.dz + first)};
    const Lanes t = hn::Div(hn::Neg(dot(normal_, w)), dot(normal_, direction));
    auto met = hn::And(hn::Ge(t, hn::LoadU(d, rays.t_min + first)), hn::Le(t, hn::LoadU(d, rays.t_max + first)));
    met = hn::And(met, hn::FirstN(d, count));
    const Lanes3 at{hn::Add(w.x, hn::Mul(t, direction.x)), hn::Add(w.y, hn::Mul(t, direction.y)),
                    hn::Add(w.z, hn::Mul(t, direction.z))};
    met = hn::And(met, hn::Le(dot(at, at), circle_));
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

  /// The corners that follow those from number `first` on, which are `a`; the first one follows the last.
  HWY_INLINE Lanes3 next_corners(const Lanes3& a, std::size_t first) const {
    const Wide d;
    const auto count = static_cast<std::size_t>(polygon_.count);
    if (count <= hn::Lanes(d)) {  // all are at hand
      alignas(64) static constexpr std::int64_t kNext[EdgeLanes::kEdges + 1][EdgeLanes::kEdges] = {
          {}, {}, {1}, {1, 2}, {1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 4, 5}, {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6, 7}};
      const auto next = hn::SetTableIndices(d, kNext[count]);
      return {hn::TableLookupLanes(a.x, next), hn::TableLookupLanes(a.y, next), hn::TableLookupLanes(a.z, next)};
    }
    const auto wraps = hn::AndNot(hn::FirstN(d, count - first - 1), hn::FirstN(d, count - first));
    const Lanes3 next = load_corners(corners_, first + 1), around = broadcast(corners_[0]);
    return {hn::IfThenElse(wraps, around.x, next.x), hn::IfThenElse(wraps, around.y, next.y),
            hn::IfThenElse(wraps, around.z, next.z)};
  }

  /// The polygon's corners with room behind them to load whole vectors.
  HWY_INLINE const dvec3* corners() const {
    const auto first = static_cast<std::size_t>(polygon_.first), count = static_cast<std::size_t>(polygon_.count);
    const dvec3* corner = surface_.vertices.data() + first;
    return first + count + EdgeLanes::kEdges < surface_.vertices.size() ? corner : copy_corners(corner, count);
  }
  HWY_NOINLINE const dvec3* copy_corners(const dvec3* corner, std::size_t count) const {
    edges_.corners.resize(count + EdgeLanes::kEdges + 1);
    std::copy_n(corner, count, edges_.corners.begin());
    return edges_.corners.data();
  }

  /// Squared radius about the centroid that holds the polygon and what reaches over its rim [m^2]. Of many rays that
  /// meet the plane of a small polygon, it spares most the edges.
  HWY_INLINE Lanes find_circle() const {
    const Wide d;
    const auto count = static_cast<std::size_t>(polygon_.count);
    Lanes farthest = hn::Zero(d);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
      const Lanes3 a = load_corners(corners_, k);
      const Lanes3 outward{hn::Sub(a.x, centroid_.x), hn::Sub(a.y, centroid_.y), hn::Sub(a.z, centroid_.z)};
      farthest = hn::Max(farthest, hn::IfThenElseZero(hn::FirstN(d, count - k), dot(outward, outward)));
    }
    // (r + reach)^2 <= (1 + 1e-4) r^2 + (1 + 1e4) reach^2 where reach <= kRimReach (l1 + 4 count r), an edge being no
    // longer than 2 r, by its components 4 r: only rays outside for certain are left out.
    const double l1 = std::abs(polygon_.centroid.x) + std::abs(polygon_.centroid.y) + std::abs(polygon_.centroid.z);
    const double edges = 4.0 * polygon_.count;
    constexpr double kReach = 2.2e4 * kRimReach * kRimReach;
    return hn::Add(hn::Mul(hn::Set(d, 1.0002 + kReach * edges * edges), hn::MaxOfLanes(d, farthest)),
                   hn::Set(d, kReach * l1 * l1));
  }

  /// fill_edge_planes(), in its order of operations.
  void make_ready() {
    const Wide d;
    const auto count = static_cast<std::size_t>(polygon_.count);
    edges_.groups.resize(std::max(edges_.groups.size(), (count + EdgeLanes::kEdges - 1) / EdgeLanes::kEdges));
    Lanes longest = hn::Zero(d);
    for (std::size_t k = 0; k < edges_.groups.size() * EdgeLanes::kEdges; k += hn::Lanes(d)) {
      EdgeLanes::Group& group = edges_.groups[k / EdgeLanes::kEdges];
      const std::size_t i = k % EdgeLanes::kEdges;
      if (k >= count) {
        for (auto* values : {&group.mx, &group.my, &group.mz, &group.c}) hn::Store(hn::Zero(d), d, &(*values)[i]);
        continue;
      }
      const auto used = hn::FirstN(d, count - k);
      const Lanes3 a = load_corners(corners_, k), next = next_corners(a, k);
      const auto edge = [&](Lanes from, Lanes to) { return hn::IfThenElseZero(used, hn::Sub(to, from)); };
      const Lanes3 e{edge(a.x, next.x), edge(a.y, next.y), edge(a.z, next.z)};
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
    }
    const double longest_edge = hn::GetLane(hn::MaxOfLanes(d, longest));
    shift_outward(hn::Set(d, edge_shift(polygon_, longest_edge)));
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
  const dvec3* corners_;  // with room behind the last
  Lanes circle_;
  bool ready_ = false;  // the edges are
};

bool run_through_tets(const TetTable& table, const ContactSurface& surface, int surface_number, EdgeLanes& edges,
                      RayHits& hits) {
  const RayLanes rays = table.lanes();
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    const ContactPolygon& polygon = surface.polygons[p];
    if (!table.has(polygon.tet)) return false;
    const auto [first, last] = table.rays_of(polygon.tet);
    if (first == last) continue;
    PolygonTest(surface, polygon, edges).offer(rays, first, last, {surface_number, static_cast<int>(p), 0, 0}, hits);
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
