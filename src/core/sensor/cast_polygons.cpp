// Contact polygons against the rays listed for them, by tet or by cell, as many at a time as the machine has lanes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sensor/cast_polygons.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "core/sensor/polygon_lanes_inl.h"
#include "core/sensor/ray_grid.h"
#include "core/sensor/tet_table.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

/// One surface's polygons, in blocks that go through the stages of CastBuffers. No stage branches on what a single ray
/// does: which ray meets what is as good as random, and a wrong guess costs as much as testing several rays.
class SurfaceCast {
 public:
  static constexpr std::size_t kBlock = 128;  // polygons: what they list stays in the caches

  SurfaceCast(std::span<const SensorRay> rays, const ContactSurface& surface, int surface_number, CastBuffers& buffers,
              RayHits& hits)
      : rays_(rays), surface_(surface), number_(surface_number), buffers_(buffers), hits_(hits) {
    buffers_.circle.resize(kBlock);
  }

  /// Stage 1 for one polygon: rays of its tet that pass by it.
  HWY_INLINE void list_near(std::size_t p, const RayView& view, std::span<const TetTable::Tile> tiles) {
    const Single f;
    const hn::Rebind<std::int32_t, Single> n;
    make_room(tiles.size() * TetTable::Tile::kRays);
    const dvec3& c = surface_.polygons[p].centroid;
    const InView centroid(view, c), normal(view, surface_.polygons[p].normal);
    const auto h = hn::Set(f, centroid.at[0]), u_c = hn::Set(f, centroid.at[1]), v_c = hn::Set(f, centroid.at[2]);
    const auto n_h = hn::Set(f, normal.at[0]), n_u = hn::Set(f, normal.at[1]), n_v = hn::Set(f, normal.at[2]);
    const auto rounding = static_cast<float>(kSingleRounding * (std::abs(c.x) + std::abs(c.y) + std::abs(c.z)));
    const float reach = view.stretch * radius(p) + view.spread + rounding;
    const auto limit = hn::Set(f, std::min(1.00001F * reach * reach, std::numeric_limits<float>::max()));
    const auto slack = hn::Set(f, 4.0F * (view.spread + rounding));
    for (const TetTable::Tile& tile : tiles) {
      for (std::size_t i = 0; i < TetTable::Tile::kRays; i += hn::Lanes(f)) {
        const auto u_slope = hn::Load(f, &tile.u_slope[i]), v_slope = hn::Load(f, &tile.v_slope[i]);
        // At the depth of the centroid, from it; and from there, heights above the plane at the piece's middle and end.
        const auto u = hn::Sub(hn::MulAdd(h, u_slope, hn::Load(f, &tile.u[i])), u_c);
        const auto v = hn::Sub(hn::MulAdd(h, v_slope, hn::Load(f, &tile.v[i])), v_c);
        const auto rise = hn::MulAdd(n_u, u_slope, hn::MulAdd(n_v, v_slope, n_h));
        const auto height =
            hn::MulAdd(hn::Sub(hn::Load(f, &tile.middle[i]), h), rise, hn::MulAdd(n_u, u, hn::Mul(n_v, v)));
        const auto near =
            hn::And(hn::Le(hn::MulAdd(u, u, hn::Mul(v, v)), limit),
                    hn::Le(hn::Abs(height), hn::MulAdd(hn::Load(f, &tile.half[i]), hn::Abs(rise), slack)));
        append(p, hn::Load(n, &tile.ray[i]), hn::RebindMask(n, near));
      }
    }
  }

  /// The same for the cells of a grid under it.
  HWY_INLINE void list_near(std::size_t p, const RayGrid& grid) {
    const Single f;
    const hn::Rebind<std::int32_t, Single> n;
    const ContactPolygon& polygon = surface_.polygons[p];
    const dvec3 c = grid.to_grid(polygon.centroid);
    const auto x_c = hn::Set(f, static_cast<float>(c.x)), y_c = hn::Set(f, static_cast<float>(c.y));
    const float reach =
        radius(p) + grid.slack() + static_cast<float>(kSingleRounding * (std::abs(c.x) + std::abs(c.y)));
    const auto limit = hn::Set(f, std::min(1.00001F * reach * reach, std::numeric_limits<float>::max()));
    grid.visit(surface_, polygon, [&](std::size_t first, std::size_t last) {
      make_room(last - first);
      for (; first < last; first += hn::Lanes(f)) {
        const auto x = hn::Sub(hn::LoadU(f, grid.x() + first), x_c), y = hn::Sub(hn::LoadU(f, grid.y() + first), y_c);
        const auto near = hn::And(hn::Le(hn::MulAdd(x, x, hn::Mul(y, y)), limit), hn::FirstN(f, last - first));
        append(p, hn::LoadU(n, grid.rays() + first), hn::RebindMask(n, near));
      }
    });
  }

  /// The other stages: offers what was listed.
  void flush() {
    meet_planes();
    keep_inside();
    for (std::size_t k = 0; k < inside_; ++k) offer(static_cast<std::size_t>(buffers_.inside[k]));
    near_ = met_ = inside_ = 0;
  }

 private:
  using Single = hn::CappedTag<float, TetTable::Tile::kRays>;
  /// A vector along the axes of a view.
  struct InView {
    alignas(16) std::array<float, 4> at{};
    HWY_INLINE InView(const RayView& view, const dvec3& v) {
      const hn::CappedTag<float, 4> f;
      const auto x = hn::Set(f, static_cast<float>(v.x)), y = hn::Set(f, static_cast<float>(v.y)),
                 z = hn::Set(f, static_cast<float>(v.z));
      for (std::size_t i = 0; i < 4; i += hn::Lanes(f)) {
        const auto xy = hn::MulAdd(x, hn::LoadU(f, &view.x[i]), hn::Mul(y, hn::LoadU(f, &view.y[i])));
        hn::Store(hn::MulAdd(z, hn::LoadU(f, &view.z[i]), xy), f, &at[i]);
      }
    }
  };

  HWY_INLINE void make_room(std::size_t more) {
    const std::size_t size = near_ + more + TetTable::Tile::kRays;
    if (size <= buffers_.t.size()) return;
    for (auto* numbers : {&buffers_.near_polygon, &buffers_.near_ray, &buffers_.met, &buffers_.inside})
      numbers->resize(2 * size);
    for (auto* values : {&buffers_.t, &buffers_.x, &buffers_.y, &buffers_.z}) values->resize(2 * size);
  }

  template <class Rays, class Mask>
  HWY_INLINE void append(std::size_t p, Rays rays, Mask near) {
    const hn::Rebind<std::int32_t, Single> n;
    hn::StoreU(hn::Set(n, static_cast<std::int32_t>(p)), n, buffers_.near_polygon.data() + near_);
    hn::StoreU(hn::Compress(rays, near), n, buffers_.near_ray.data() + near_);
    near_ += hn::CountTrue(n, near);
  }

  /// Of the circle that holds the polygon, which is kept [m].
  [[nodiscard]] HWY_INLINE float radius(std::size_t p) {
    const double squared = PolygonLanes(surface_, surface_.polygons[p], buffers_).circle();
    buffers_.circle[p % kBlock] = squared;
    return std::sqrt(static_cast<float>(squared));
  }

  /// Stage 2: the plane, and the circle in it, of as many pairs as there are lanes. As hit_polygon().
  HWY_INLINE void meet_planes() {
    const Wide d;
    const hn::Rebind<std::int64_t, Wide> n;
    const hn::Rebind<std::int32_t, Wide> narrow_n;
    if (near_ == 0) return;
    static_assert(sizeof(ContactPolygon) == 14 * sizeof(double) && sizeof(SensorRay) == 8 * sizeof(double));
    static_assert(offsetof(ContactPolygon, centroid) == offsetof(ContactPolygon, normal) + 4 * sizeof(double));
    static_assert(offsetof(SensorRay, direction) == offsetof(SensorRay, origin) + 3 * sizeof(double) &&
                  offsetof(SensorRay, max_depth) == offsetof(SensorRay, origin) + 6 * sizeof(double));
    const double *polygons = &surface_.polygons.data()->normal.x, *rays = &rays_.data()->origin.x;
    for (std::size_t k = 0; k < near_; k += hn::Lanes(d)) {
      const auto used = hn::FirstN(n, near_ - k);
      const auto p = hn::IfThenElseZero(used, hn::PromoteTo(n, hn::LoadU(narrow_n, &buffers_.near_polygon[k])));
      const auto r = hn::IfThenElseZero(used, hn::PromoteTo(n, hn::LoadU(narrow_n, &buffers_.near_ray[k])));
      const auto ip = hn::Sub(hn::ShiftLeft<4>(p), hn::ShiftLeft<1>(p)), ir = hn::ShiftLeft<3>(r);
      const auto gather3 = [&](const double* from, auto index) {
        return Lanes3{hn::GatherIndex(d, from, index), hn::GatherIndex(d, from + 1, index),
                      hn::GatherIndex(d, from + 2, index)};
      };
      const Lanes3 normal = gather3(polygons, ip), centroid = gather3(polygons + 4, ip), origin = gather3(rays, ir),
                   direction = gather3(rays + 3, ir);
      const Lanes3 w{hn::Sub(origin.x, centroid.x), hn::Sub(origin.y, centroid.y), hn::Sub(origin.z, centroid.z)};
      const Lanes t = hn::Div(hn::Neg(dot(normal, w)), dot(normal, direction));
      const Lanes3 at{hn::Add(w.x, hn::Mul(t, direction.x)), hn::Add(w.y, hn::Mul(t, direction.y)),
                      hn::Add(w.z, hn::Mul(t, direction.z))};
      const Lanes circle = hn::GatherIndex(d, buffers_.circle.data(), hn::And(p, hn::Set(n, kBlock - 1)));
      auto met = hn::And(hn::Ge(t, hn::Zero(d)), hn::Le(t, hn::GatherIndex(d, rays + 6, ir)));
      met = hn::And(hn::And(met, hn::RebindMask(d, used)), hn::Le(dot(at, at), circle));
      hn::StoreU(t, d, &buffers_.t[k]);
      hn::StoreU(at.x, d, &buffers_.x[k]);
      hn::StoreU(at.y, d, &buffers_.y[k]);
      hn::StoreU(at.z, d, &buffers_.z[k]);
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, met, bits);
      hn::StoreU(hn::Compress(hn::Iota(narrow_n, static_cast<std::int32_t>(k)), hn::LoadMaskBits(narrow_n, bits)),
                 narrow_n, &buffers_.met[met_]);
      met_ += hn::CountTrue(d, met);
    }
  }

  /// Stage 3: the edges.
  HWY_INLINE void keep_inside() {
    std::int32_t ready = -1;
    PolygonLanes::FewEdges few{};
    for (std::size_t j = 0; j < met_; ++j) {
      const auto k = static_cast<std::size_t>(buffers_.met[j]);
      const std::int32_t p = buffers_.near_polygon[k];
      const ContactPolygon& polygon = surface_.polygons[static_cast<std::size_t>(p)];
      const bool is_few = PolygonLanes::has_few_edges(polygon);
      if (p != std::exchange(ready, p)) {
        PolygonLanes lanes(surface_, polygon, buffers_);
        if (is_few)
          few = lanes.few_edges();
        else
          lanes.fill_edges();
      }
      const bool in = is_few ? PolygonLanes::inside(few, from_centroid(k))
                             : PolygonLanes::inside(buffers_, polygon.count, from_centroid(k));
      buffers_.inside[inside_] = static_cast<std::int32_t>(k);
      inside_ += static_cast<std::size_t>(in);
    }
  }

  HWY_INLINE void offer(std::size_t k) {
    const ContactPolygon& polygon = surface_.polygons[static_cast<std::size_t>(buffers_.near_polygon[k])];
    const double pressure = std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, from_centroid(k)));
    hits_.offer(buffers_.near_ray[k], {number_, buffers_.near_polygon[k], buffers_.t[k], pressure});
  }

  [[nodiscard]] HWY_INLINE dvec3 from_centroid(std::size_t pair) const {
    return {buffers_.x[pair], buffers_.y[pair], buffers_.z[pair]};
  }

  std::span<const SensorRay> rays_;
  const ContactSurface& surface_;
  int number_;
  CastBuffers& buffers_;
  RayHits& hits_;
  std::size_t near_ = 0, met_ = 0, inside_ = 0;
};

bool run_through_tets(const TetTable& table, std::span<const SensorRay> rays, const ContactSurface& surface,
                      int surface_number, CastBuffers& buffers, RayHits& hits) {
  SurfaceCast cast(rays, surface, surface_number, buffers, hits);
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    const int tet = surface.polygons[p].tet;
    if (!table.has(tet)) return false;
    const auto tiles = table.rays_of(tet);
    if (!tiles.empty()) cast.list_near(p, table.view_of(tet), tiles);
    if ((p + 1) % SurfaceCast::kBlock == 0) cast.flush();
  }
  cast.flush();
  return true;
}

void run_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                      int surface_number, CastBuffers& buffers, RayHits& hits) {
  SurfaceCast cast(rays, surface, surface_number, buffers, hits);
  for (std::size_t p = 0; p < surface.polygons.size(); ++p) {
    cast.list_near(p, grid);
    if ((p + 1) % SurfaceCast::kBlock == 0) cast.flush();
  }
  cast.flush();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_through_tets);
HWY_EXPORT(run_through_grid);

bool cast_through_tets(const TetTable& table, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits) {
  return HWY_DYNAMIC_DISPATCH(run_through_tets)(table, rays, surface, surface_number, buffers, hits);
}

void cast_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits) {
  HWY_DYNAMIC_DISPATCH(run_through_grid)(grid, rays, surface, surface_number, buffers, hits);
}
}  // namespace taxel
#endif
