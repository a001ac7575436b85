// One contact polygon in lanes of its corners and edges: a circle that holds it, and its edge planes (edge_planes.h).
// Compiled once per instruction set.
#if defined(TAXEL_SENSOR_POLYGON_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_SENSOR_POLYGON_LANES_INL_H_
#undef TAXEL_SENSOR_POLYGON_LANES_INL_H_
#else
#define TAXEL_SENSOR_POLYGON_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "core/sensor/cast_buffers.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::CappedTag<double, CastBuffers::kEdges>;
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

/// One polygon in lanes of its corners and edges.
class PolygonLanes {
 public:
  HWY_INLINE PolygonLanes(const ContactSurface& surface, const ContactPolygon& polygon, CastBuffers& buffers)
      : surface_(surface), polygon_(polygon), buffers_(buffers), corners_(corners()) {}

  /// Squared radius about the centroid that holds the polygon and what reaches over its rim [m^2]. Of many rays that
  /// meet the plane of a small polygon, it spares most the edges.
  [[nodiscard]] HWY_INLINE double circle() const {
    const Wide d;
    const Lanes3 centroid = broadcast(polygon_.centroid);
    const auto count = static_cast<std::size_t>(polygon_.count);
    Lanes farthest = hn::Zero(d);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
      const Lanes3 a = load_corners(corners_, k);
      const Lanes3 outward{hn::Sub(a.x, centroid.x), hn::Sub(a.y, centroid.y), hn::Sub(a.z, centroid.z)};
      farthest = hn::Max(farthest, hn::IfThenElseZero(hn::FirstN(d, count - k), dot(outward, outward)));
    }
    // (r + reach)^2 <= (1 + 1e-4) r^2 + (1 + 1e4) reach^2 where reach <= kRimReach (l1 + 4 count r), an edge being no
    // longer than 2 r, by its components 4 r: only rays outside for certain are left out.
    const double l1 = std::abs(polygon_.centroid.x) + std::abs(polygon_.centroid.y) + std::abs(polygon_.centroid.z);
    const double edges = 4.0 * polygon_.count;
    constexpr double kReach = 2.2e4 * kRimReach * kRimReach;
    return (1.0002 + kReach * edges * edges) * hn::GetLane(hn::MaxOfLanes(d, farthest)) + kReach * l1 * l1;
  }

  /// All edges fit in the lanes.
  [[nodiscard]] static HWY_INLINE bool has_few_edges(const ContactPolygon& polygon) {
    return static_cast<std::size_t>(polygon.count) <= hn::Lanes(Wide());
  }
  struct FewEdges {
    Lanes3 m;
    Lanes c;
  };
  /// fill_edge_planes(), in its order of operations.
  [[nodiscard]] HWY_INLINE FewEdges few_edges() const {
    const Wide d;
    const EdgeVectors edges = edges_from(0);
    const Lanes shift = hn::Set(d, edge_shift(polygon_, hn::GetLane(hn::MaxOfLanes(d, edges.length_l1))));
    return {edges.m, hn::Add(edges.c, hn::Mul(shift, edges.length))};
  }
  [[nodiscard]] static HWY_INLINE bool inside(const FewEdges& few, const dvec3& from_centroid) {
    const Wide d;
    return hn::AllTrue(d, hn::Ge(hn::Add(dot(few.m, broadcast(from_centroid)), few.c), hn::Zero(d)));
  }

  /// The same of any polygon, into the buffers.
  HWY_INLINE void fill_edges() {
    const Wide d;
    const auto count = static_cast<std::size_t>(polygon_.count);
    buffers_.edges.resize(std::max(buffers_.edges.size(), (count + CastBuffers::kEdges - 1) / CastBuffers::kEdges));
    Lanes longest = hn::Zero(d);
    for (std::size_t k = 0; k < buffers_.edges.size() * CastBuffers::kEdges; k += hn::Lanes(d)) {
      CastBuffers::Edges& group = buffers_.edges[k / CastBuffers::kEdges];
      const std::size_t i = k % CastBuffers::kEdges;
      if (k >= count) {
        for (auto* values : {&group.mx, &group.my, &group.mz, &group.c}) hn::Store(hn::Zero(d), d, &(*values)[i]);
        continue;
      }
      const EdgeVectors edges = edges_from(k);
      longest = hn::Max(longest, edges.length_l1);
      hn::Store(edges.length, d, &group.length[i]);
      hn::Store(edges.m.x, d, &group.mx[i]);
      hn::Store(edges.m.y, d, &group.my[i]);
      hn::Store(edges.m.z, d, &group.mz[i]);
      hn::Store(edges.c, d, &group.c[i]);
    }
    const double longest_edge = hn::GetLane(hn::MaxOfLanes(d, longest));
    shift_outward(hn::Set(d, edge_shift(polygon_, longest_edge)));
  }

  /// Inside the edges that fill_edges() left there.
  [[nodiscard]] static HWY_INLINE bool inside(const CastBuffers& buffers, int count, const dvec3& from_centroid) {
    const Wide d;
    const Lanes3 y = broadcast(from_centroid);
    auto in = hn::FirstN(d, hn::Lanes(d));
    for (std::size_t g = 0; g * CastBuffers::kEdges < static_cast<std::size_t>(count); ++g) {
      const CastBuffers::Edges& group = buffers.edges[g];
      for (std::size_t i = 0; i < CastBuffers::kEdges; i += hn::Lanes(d)) {
        const Lanes3 m{hn::Load(d, &group.mx[i]), hn::Load(d, &group.my[i]), hn::Load(d, &group.mz[i])};
        in = hn::And(in, hn::Ge(hn::Add(dot(m, y), hn::Load(d, &group.c[i])), hn::Zero(d)));
      }
    }
    return hn::AllTrue(d, in);
  }

 private:
  /// Edges in lanes, 0 beyond the last: their planes before they are moved outward, and lengths by the largest and by
  /// the sum of the components [m].
  struct EdgeVectors {
    Lanes3 m;
    Lanes c, length, length_l1;
  };
  HWY_INLINE EdgeVectors edges_from(std::size_t k) const {
    const Wide d;
    const Lanes3 normal = broadcast(polygon_.normal), centroid = broadcast(polygon_.centroid);
    const auto used = hn::FirstN(d, static_cast<std::size_t>(polygon_.count) - k);
    const Lanes3 a = load_corners(corners_, k), next = next_corners(a, k);
    const auto edge = [&](Lanes from, Lanes to) { return hn::IfThenElseZero(used, hn::Sub(to, from)); };
    const Lanes3 e{edge(a.x, next.x), edge(a.y, next.y), edge(a.z, next.z)};
    const Lanes3 size{hn::Abs(e.x), hn::Abs(e.y), hn::Abs(e.z)};
    const Lanes3 m{hn::Sub(hn::Mul(normal.y, e.z), hn::Mul(e.y, normal.z)),
                   hn::Sub(hn::Mul(normal.z, e.x), hn::Mul(e.z, normal.x)),
                   hn::Sub(hn::Mul(normal.x, e.y), hn::Mul(e.x, normal.y))};
    const Lanes3 inward{hn::Sub(centroid.x, a.x), hn::Sub(centroid.y, a.y), hn::Sub(centroid.z, a.z)};
    return {m, hn::IfThenElseZero(used, dot(m, inward)), hn::Max(hn::Max(size.x, size.y), size.z),
            hn::Add(hn::Add(size.x, size.y), size.z)};
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
      alignas(64) static constexpr std::int64_t kNext[CastBuffers::kEdges + 1][CastBuffers::kEdges] = {
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
    return first + count + CastBuffers::kEdges < surface_.vertices.size() ? corner : copy_corners(corner, count);
  }
  HWY_NOINLINE const dvec3* copy_corners(const dvec3* corner, std::size_t count) const {
    buffers_.corners.resize(count + CastBuffers::kEdges + 1);
    std::copy_n(corner, count, buffers_.corners.begin());
    return buffers_.corners.data();
  }

  HWY_INLINE void shift_outward(Lanes s) {
    const Wide d;
    for (std::size_t k = 0; k < static_cast<std::size_t>(polygon_.count); k += hn::Lanes(d)) {
      CastBuffers::Edges& group = buffers_.edges[k / CastBuffers::kEdges];
      const std::size_t i = k % CastBuffers::kEdges;
      hn::Store(hn::Add(hn::Load(d, &group.c[i]), hn::Mul(s, hn::Load(d, &group.length[i]))), d, &group.c[i]);
    }
  }

  const ContactSurface& surface_;
  const ContactPolygon& polygon_;
  CastBuffers& buffers_;
  const dvec3* corners_;  // with room behind the last
};

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // TAXEL_SENSOR_POLYGON_LANES_INL_H_
