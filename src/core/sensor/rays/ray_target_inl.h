// Prepares a contact polygon for rays and tests it against one ray per SIMD lane, in single precision. Compiled once
// per instruction set.
//
// The polygon is seen along the rays: its corners relative to its centroid give edges du v - dv u + c,
// counter-clockwise along the rays, in groups of four. A ray meets the plane of the polygon at the depth of the
// centroid less its height over the plane divided by its rise, and the least of its values for all edges is positive
// inside. The value must exceed a slack, which bounds the rounding of coordinates and grows for rays across the plane;
// between slack and -slack a ray is undecided. Polygons with too many corners and planes nearly along the rays have an
// infinite slack, so every ray is undecided.
#if defined(TAXEL_SENSOR_RAY_TARGET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TAXEL_SENSOR_RAY_TARGET_INL_H_
#undef TAXEL_SENSOR_RAY_TARGET_INL_H_
#else
#define TAXEL_SENSOR_RAY_TARGET_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/sensor/rays/ray_target.h"
#include "core/sensor/rays/sensor_ray.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Fills a target of at most 4 kGroups edges.
template <std::size_t kGroups>
class TargetMaker {
 public:
  HWY_INLINE TargetMaker(const RayView& view, const ContactSurface& surface, const ContactPolygon& polygon,
                         CastBuffers& buffers, RayTarget& target)
      : view_(view), polygon_(polygon), target_(target) {
    const auto count = static_cast<std::size_t>(polygon.count);
    look(polygon.centroid, target.centroid);
    look(polygon.normal, target.normal);
    const dvec3* corner = surface.vertices.data() + polygon.first;
    if (static_cast<std::size_t>(polygon.first) + kGroups * kGroup > surface.vertices.size())
      corner = copy_corners(corner, count, buffers);
    if (kGroups == 1 && hn::Lanes(Four()) == kGroup)
      set_few(corner, count);
    else
      set_many(corner, count);
  }

 private:
  static constexpr std::size_t kGroup = RayTarget::kGroup;
  using Four = hn::CappedTag<float, kGroup>;
  using Floats = hn::Vec<Four>;

  /// Computes the components of p along the axes of the view.
  HWY_INLINE void look(const dvec3& p, std::array<float, 4>& seen) const {
    const Four f;
    const auto x = hn::Set(f, static_cast<float>(p.x)), y = hn::Set(f, static_cast<float>(p.y)),
               z = hn::Set(f, static_cast<float>(p.z));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(f)) {
      const auto xy = hn::MulAdd(x, hn::LoadU(f, &view_.x[i]), hn::Mul(y, hn::LoadU(f, &view_.y[i])));
      hn::StoreU(hn::MulAdd(z, hn::LoadU(f, &view_.z[i]), xy), f, &seen[i]);
    }
  }

  /// Computes u and v of a group of corners, relative to the centroid.
  HWY_INLINE void project(const dvec3* corner, float* u, float* v) const {
    const hn::CappedTag<double, kGroup> d;
    const hn::Rebind<float, decltype(d)> f;
    for (std::size_t i = 0; i < kGroup; i += hn::Lanes(d)) {
      hn::Vec<decltype(d)> x, y, z;
      hn::LoadInterleaved3(d, &corner[i].x, x, y, z);
      const auto xf = hn::DemoteTo(f, hn::Sub(x, hn::Set(d, polygon_.centroid.x))),
                 yf = hn::DemoteTo(f, hn::Sub(y, hn::Set(d, polygon_.centroid.y))),
                 zf = hn::DemoteTo(f, hn::Sub(z, hn::Set(d, polygon_.centroid.z)));
      const auto along = [&](std::size_t axis) {
        return hn::MulAdd(xf, hn::Set(f, view_.x[axis]),
                          hn::MulAdd(yf, hn::Set(f, view_.y[axis]), hn::Mul(zf, hn::Set(f, view_.z[axis]))));
      };
      hn::StoreU(along(1), f, &u[i]);
      hn::StoreU(along(2), f, &v[i]);
    }
  }

  /// Sets the edges of a polygon whose corners fit in the lanes, where they are permuted.
  HWY_INLINE void set_few(const dvec3* corner, std::size_t count) {
    const Four f;
    alignas(16) std::array<float, kGroup> at_u, at_v;
    project(corner, at_u.data(), at_v.data());
    const auto u = hn::Load(f, at_u.data()), v = hn::Load(f, at_v.data());
    alignas(16) static constexpr std::int32_t kFrom[kGroup + 1][kGroup] = {
        {}, {}, {0, 1, 0, 1}, {0, 1, 2, 0}, {0, 1, 2, 3}};
    alignas(16) static constexpr std::int32_t kTo[kGroup + 1][kGroup] = {
        {}, {}, {1, 0, 1, 0}, {1, 2, 0, 1}, {1, 2, 3, 0}};
    const auto from = hn::SetTableIndices(f, kFrom[count]), to = hn::SetTableIndices(f, kTo[count]);
    set_slack(set_edges(hn::TableLookupLanes(u, from), hn::TableLookupLanes(v, from), hn::TableLookupLanes(u, to),
                        hn::TableLookupLanes(v, to), 0));
  }

  HWY_INLINE void set_many(const dvec3* corner, std::size_t count) {
    const Four f;
    constexpr std::size_t kMost = kGroups * kGroup;
    if (count > kMost) {  // every ray is undecided
      for (RayTarget::Edges& edges : target_.edges) edges = {};
      target_.slack = target_.tilt = std::numeric_limits<float>::infinity();
      return;
    }
    std::array<float, 2 * kMost + 1> u, v;
    for (std::size_t k = 0; k < kMost; k += kGroup) project(corner + k, &u[k], &v[k]);
    for (std::size_t k = 0; k <= kGroup; ++k) u[count + k] = u[k], v[count + k] = v[k];
    auto far = hn::Zero(f);
    for (std::size_t k = 0; k < kMost; k += hn::Lanes(f))
      far = hn::Max(far, set_edges(hn::LoadU(f, &u[k]), hn::LoadU(f, &v[k]), hn::LoadU(f, &u[k + 1]),
                                   hn::LoadU(f, &v[k + 1]), k));
    set_slack(far);
  }

  /// Sets edges counter-clockwise as seen along the rays. Returns the distances of first corners from the centroid.
  HWY_INLINE Floats set_edges(Floats from_u, Floats from_v, Floats to_u, Floats to_v, std::size_t k) {
    const Four f;
    RayTarget::Edges& edges = target_.edges[k / kGroup];
    const auto side = hn::And(hn::SignBit(f), hn::Set(f, target_.normal[0]));
    const auto du = hn::Xor(side, hn::Sub(to_u, from_u)), dv = hn::Xor(side, hn::Sub(to_v, from_v));
    hn::StoreU(du, f, &edges.du[k % kGroup]);
    hn::StoreU(dv, f, &edges.dv[k % kGroup]);
    hn::StoreU(hn::NegMulAdd(du, from_v, hn::Mul(dv, from_u)), f, &edges.c[k % kGroup]);
    return hn::Add(hn::Abs(from_u), hn::Abs(from_v));
  }

  HWY_INLINE void set_slack(Floats far) {
    const float extent = hn::GetLane(hn::MaxOfLanes(Four(), far));
    const std::array<float, 4>& c = target_.centroid;
    const float coordinates = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]) + extent;
    // Edges are at most twice as long as the extent. For steep planes not even the side is certain.
    constexpr float kSteep = 1e-3F;
    const float slack = 2.0F * extent * (view_.spread + static_cast<float>(kSingleRounding) * coordinates);
    target_.slack = std::abs(target_.normal[0]) > kSteep ? slack : std::numeric_limits<float>::infinity();
    target_.tilt = slack * view_.tilt;
  }

  /// Copies corners with padding, so that whole groups can be loaded.
  static HWY_NOINLINE const dvec3* copy_corners(const dvec3* corner, std::size_t count, CastBuffers& buffers) {
    buffers.corners.resize(std::max(count, kGroups * kGroup));
    std::copy_n(corner, count, buffers.corners.begin());
    return buffers.corners.data();
  }

  const RayView& view_;
  const ContactPolygon& polygon_;
  RayTarget& target_;
};

/// Rays in lanes, by their places in a view.
template <class Tag>
class RayLanes {
 public:
  using Floats = hn::Vec<Tag>;
  /// The rays that surely hit the target, and those that surely miss it.
  struct Met {
    hn::Mask<Tag> in, out;
  };

  HWY_INLINE RayLanes(Floats u, Floats v, Floats u_slope, Floats v_slope)
      : u_at_0_(u), v_at_0_(v), u_slope_(u_slope), v_slope_(v_slope) {}

  template <std::size_t kGroups>
  HWY_INLINE Met meet(const RayTarget& target) const {
    const Tag f;
    const auto n_h = hn::Set(f, target.normal[0]), n_u = hn::Set(f, target.normal[1]),
               n_v = hn::Set(f, target.normal[2]);
    const auto u = u_from(target), v = v_from(target);  // then in the plane
    const auto per_rise = hn::Div(hn::Set(f, 1.0F), hn::MulAdd(n_u, u_slope_, hn::MulAdd(n_v, v_slope_, n_h)));
    const auto above = hn::Mul(per_rise, hn::MulAdd(n_u, u, hn::Mul(n_v, v)));
    const auto x = hn::NegMulAdd(above, u_slope_, u), y = hn::NegMulAdd(above, v_slope_, v);
    Floats inside = hn::Set(f, std::numeric_limits<float>::max());
    for (std::size_t g = 0; g < kGroups; ++g) {
      const RayTarget::Edges& edges = target.edges[g];
      for (std::size_t k = 0; k < RayTarget::kGroup; ++k) {
        const auto across = hn::NegMulAdd(hn::Set(f, edges.dv[k]), x, hn::Set(f, edges.c[k]));
        inside = hn::Min(inside, hn::MulAdd(hn::Set(f, edges.du[k]), y, across));
      }
    }
    const auto slack = hn::MulAdd(hn::Abs(per_rise), hn::Set(f, target.tilt), hn::Set(f, target.slack));
    return {hn::Gt(inside, slack), hn::Lt(inside, hn::Neg(slack))};
  }

  /// Returns the rays within a distance in u and v from the target's centroid, at its depth [m].
  HWY_INLINE hn::Mask<Tag> pass_within(float distance, const RayTarget& target) const {
    const auto limit = hn::Set(Tag(), distance);
    return hn::And(hn::Le(hn::Abs(u_from(target)), limit), hn::Le(hn::Abs(v_from(target)), limit));
  }

 private:
  /// Returns u at the depth of the target's centroid, relative to the centroid.
  HWY_INLINE Floats u_from(const RayTarget& target) const {
    const Tag f;
    const auto h = hn::Set(f, target.centroid[0]);
    return hn::Sub(hn::MulAdd(h, u_slope_, u_at_0_), hn::Set(f, target.centroid[1]));
  }
  HWY_INLINE Floats v_from(const RayTarget& target) const {
    const Tag f;
    const auto h = hn::Set(f, target.centroid[0]);
    return hn::Sub(hn::MulAdd(h, v_slope_, v_at_0_), hn::Set(f, target.centroid[2]));
  }

  Floats u_at_0_, v_at_0_, u_slope_, v_slope_;
};

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // TAXEL_SENSOR_RAY_TARGET_INL_H_
