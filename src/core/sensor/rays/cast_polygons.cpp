// Tests contact polygons against the rays listed for them by tet, cell or tile, several rays at a time by SIMD lanes.
//
// Nearly all rays clearly hit or clearly miss a polygon. In single precision, in a view along the rays (sensor_ray.h),
// a lane computes by how much a ray passes inside of all edges, and compares this with a bound of the rounding error
// (ray_target_inl.h). Rays inside are listed by compressing the lanes; rays between the bounds are tested exactly in
// double precision. After a block of polygons the listed rays get their depth and pressure, which the first hit of each
// ray keeps.
//
// The result is that of the exact test of every ray with every polygon, to the last bit, since single precision only
// decides where its error cannot matter. No branch depends on a single ray: such branches are random, and a
// mispredicted one costs as much as testing several rays. Pitfall: the numbers of the target must be loaded from memory
// (the fence in test()); kept in registers they would cost twice as much. Theory: docs/theory/sensor.md, "Rays and
// readings".
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sensor/rays/cast_polygons.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

#include "core/sensor/rays/ray_grid.h"
#include "core/sensor/rays/ray_target_inl.h"
#include "core/sensor/rays/ray_tiles.h"
#include "core/sensor/rays/tet_table.h"

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

using Single = hn::CappedTag<float, RayTile::kRays>;
using Numbers = hn::Rebind<std::int32_t, Single>;
using Rays = RayLanes<Single>;

/// Calls test(rays, indices of the rays, mask of the places with a ray) for all rays of some tiles.
template <class Test>
HWY_INLINE void visit_tiles(std::span<const RayTile> tiles, const Test& test) {
  const Single f;
  const Numbers n;
  for (const RayTile& tile : tiles) {
    for (std::size_t i = 0; i < RayTile::kRays; i += hn::Lanes(f)) {
      const auto numbers = hn::Load(n, &tile.ray[i]);
      test(Rays(hn::Load(f, &tile.u[i]), hn::Load(f, &tile.v[i]), hn::Load(f, &tile.u_slope[i]),
                hn::Load(f, &tile.v_slope[i])),
           numbers, hn::Gt(numbers, hn::Set(n, -1)));
    }
  }
}

// A source gives the rays of a polygon in one or more views: begin(), then view() and visit() while next() is true.

/// The rays of a polygon in the tiles of its tet.
class InTets {
 public:
  explicit InTets(const TetTable& table) : table_(table) {}
  static constexpr bool kManyViews = false;
  [[nodiscard]] HWY_INLINE bool knows(const ContactPolygon& polygon) const { return table_.has(polygon.tet); }
  HWY_INLINE void begin(const ContactSurface& /*surface*/, const ContactPolygon& polygon, CastBuffers& /*buffers*/) {
    tet_ = polygon.tet;
    is_left_ = !table_.rays_of(tet_).empty();
  }
  HWY_INLINE bool next() { return std::exchange(is_left_, false); }
  [[nodiscard]] HWY_INLINE const RayView& view() const { return table_.view_of(tet_); }
  template <class Test>
  HWY_INLINE void visit(const ContactSurface& /*surface*/, const ContactPolygon& /*polygon*/, const Test& test) const {
    visit_tiles(table_.rays_of(tet_), test);
  }

 private:
  const TetTable& table_;
  int tet_ = -1;
  bool is_left_ = false;
};

/// The rays of a polygon in the cells of a grid below it.
class InGrid {
 public:
  explicit InGrid(const RayGrid& grid) : grid_(grid) {}
  static constexpr bool kManyViews = false;
  [[nodiscard]] HWY_INLINE bool knows(const ContactPolygon& /*polygon*/) const { return true; }
  HWY_INLINE void begin(const ContactSurface& /*surface*/, const ContactPolygon& /*polygon*/,
                        CastBuffers& /*buffers*/) {
    is_left_ = true;
  }
  HWY_INLINE bool next() { return std::exchange(is_left_, false); }
  [[nodiscard]] HWY_INLINE const RayView& view() const { return grid_.view(); }
  template <class Test>
  HWY_INLINE void visit(const ContactSurface& surface, const ContactPolygon& polygon, const Test& test) const {
    const Single f;
    const Numbers n;
    grid_.visit(surface, polygon, [&](std::size_t first, std::size_t last) {
      for (; first < last; first += hn::Lanes(f))
        test(Rays(hn::LoadU(f, grid_.x() + first), hn::LoadU(f, grid_.y() + first), hn::Zero(f), hn::Zero(f)),
             hn::LoadU(n, grid_.rays() + first), hn::FirstN(n, last - first));
    });
  }

 private:
  const RayGrid& grid_;
  bool is_left_ = false;
};

/// The rays in the groups near a polygon, for polygons that are in no tet of a table.
class InTiles {
 public:
  InTiles(const RayTiles& tiles, const TetTable* table) : tiles_(tiles), table_(table) {}
  static constexpr bool kManyViews = true;
  [[nodiscard]] HWY_INLINE bool knows(const ContactPolygon& polygon) const {
    return table_ == nullptr || !table_->has(polygon.tet);
  }
  HWY_INLINE void begin(const ContactSurface& surface, const ContactPolygon& polygon, CastBuffers& buffers) {
    tiles_.find(surface, polygon, buffers.groups);
    left_ = buffers.groups;
  }
  HWY_INLINE bool next() {
    if (left_.empty()) return false;
    group_ = &tiles_.group(left_.front());
    left_ = left_.subspan(1);
    return true;
  }
  [[nodiscard]] HWY_INLINE const RayView& view() const { return group_->view; }
  template <class Test>
  HWY_INLINE void visit(const ContactSurface& /*surface*/, const ContactPolygon& /*polygon*/, const Test& test) const {
    visit_tiles({&group_->tile, 1}, test);
  }

 private:
  const RayTiles& tiles_;
  const TetTable* table_;
  std::span<const std::int32_t> left_;
  const RayTiles::Group* group_ = nullptr;
};

/// Casts rays on the polygons of one surface.
template <class Source>
class SurfaceCast {
 public:
  SurfaceCast(const Source& source, std::span<const SensorRay> rays, const ContactSurface& surface, int surface_number,
              CastBuffers& buffers, RayHits& hits)
      : source_(source), rays_(rays), surface_(surface), number_(surface_number), buffers_(buffers), hits_(hits) {}

  /// Returns false if there are polygons that the source does not know.
  bool run() {
    bool knows_all = true;
    for (std::size_t p = 0; p < surface_.polygons.size(); ++p) {
      const ContactPolygon& polygon = surface_.polygons[p];
      if (!source_.knows(polygon)) {
        knows_all = false;
      } else {
        source_.begin(surface_, polygon, buffers_);
        while (source_.next()) {
          if (static_cast<std::size_t>(polygon.count) <= RayTarget::kGroup)
            test<1>(static_cast<std::int32_t>(p));
          else
            test<RayTarget::kGroups>(static_cast<std::int32_t>(p));
        }
      }
      if ((p + 1) % kBlock == 0) offer_listed();
    }
    offer_listed();
    return knows_all;
  }

 private:
  static constexpr std::size_t kBlock = 128;  // number of polygons whose lists stay in the caches

  template <std::size_t kGroups>
  HWY_INLINE void test(std::int32_t p) {
    const ContactPolygon& polygon = surface_.polygons[static_cast<std::size_t>(p)];
    TargetMaker<kGroups>(source_.view(), surface_, polygon, buffers_, buffers_.target);
    if constexpr (Source::kManyViews) planes_of_ = -1;
    // The lanes load the target's numbers from memory one by one. From registers that would cost twice as much.
    std::atomic_signal_fence(std::memory_order_seq_cst);
    source_.visit(surface_, polygon, [&](const Rays& rays, auto numbers, auto used) {
      list(p, rays, numbers, rays.template meet<kGroups>(buffers_.target), used);
    });
  }

  template <class Vector, class Mask>
  HWY_INLINE void list(std::int32_t polygon, const Rays& rays, Vector numbers, const Rays::Met& met, Mask used) {
    const Numbers n;
    if (HWY_UNLIKELY(listed_ + hn::Lanes(n) > buffers_.ray.size())) make_room();
    const auto in = hn::And(hn::RebindMask(n, met.in), used);
    hn::StoreU(hn::Set(n, polygon), n, buffers_.polygon.data() + listed_);
    hn::StoreU(hn::Compress(numbers, in), n, buffers_.ray.data() + listed_);
    listed_ += hn::CountTrue(n, in);
    const auto unclear = hn::AndNot(hn::RebindMask(n, hn::Or(met.in, met.out)), used);
    if (HWY_UNLIKELY(!hn::AllFalse(n, unclear))) test_exactly(polygon, rays, numbers, unclear);
  }

  HWY_NOINLINE void make_room() {
    for (auto* numbers : {&buffers_.polygon, &buffers_.ray}) numbers->resize(2 * numbers->size() + kBlock);
  }

  /// Tests rays that single precision cannot decide: rays near a rim, or all rays of a steep plane.
  template <class Vector, class Mask>
  HWY_NOINLINE void test_exactly(std::int32_t p, const Rays& rays, Vector numbers, Mask unclear) {
    const Numbers n;
    const ContactPolygon& polygon = surface_.polygons[static_cast<std::size_t>(p)];
    if (std::exchange(planes_of_, p) != p) make_planes(polygon);
    const auto near = hn::And(unclear, hn::RebindMask(n, rays.pass_within(near_, buffers_.target)));
    alignas(64) std::array<std::int32_t, RayTile::kRays> left;
    hn::Store(hn::Compress(numbers, near), n, left.data());
    for (const std::int32_t r : std::span(left).first(hn::CountTrue(n, near))) {
      const SensorRay& ray = rays_[static_cast<std::size_t>(r)];
      const auto hit = hit_polygon(ray.origin, ray.direction, 0.0, ray.max_depth, polygon, buffers_.planes.data());
      if (hit) hits_.offer(r, {number_, p, hit->t, hit->pressure});
    }
  }

  /// Fills the planes of a polygon, and near_: how close rays that may hit it pass by its centroid, at most [m].
  void make_planes(const ContactPolygon& polygon) {
    const auto count = static_cast<std::size_t>(polygon.count);
    if (buffers_.planes.size() < count) buffers_.planes.resize(2 * count);
    fill_edge_planes(surface_, polygon, buffers_.planes.data());
    double radius = 0, coordinates = 0;
    for (std::size_t k = 0; k < count; ++k)
      radius = std::max(
          radius, glm::distance(surface_.vertices[static_cast<std::size_t>(polygon.first) + k], polygon.centroid));
    for (const float c : buffers_.target.centroid) coordinates += std::abs(c);
    const RayView& view = source_.view();  // whose rays have slopes below its tilt
    near_ = static_cast<float>((1.0 + view.tilt) * radius + view.spread + kSingleRounding * (coordinates + radius));
  }

  HWY_INLINE void offer_listed() {
    for (std::size_t k = 0; k < listed_; ++k) {
      const std::int32_t p = buffers_.polygon[k], r = buffers_.ray[k];
      const ContactPolygon& polygon = surface_.polygons[static_cast<std::size_t>(p)];
      const SensorRay& ray = rays_[static_cast<std::size_t>(r)];
      const auto hit = hit_plane(ray.origin, ray.direction, 0.0, ray.max_depth, polygon);
      if (hit) hits_.offer(r, {number_, p, hit->t, pressure_at(polygon, hit->from_centroid)});
    }
    listed_ = 0;
  }

  Source source_;
  std::span<const SensorRay> rays_;
  const ContactSurface& surface_;
  int number_;
  CastBuffers& buffers_;
  RayHits& hits_;
  std::size_t listed_ = 0;
  std::int32_t planes_of_ = -1;  // polygon with planes and near_
  float near_ = 0;               // of it [m]
};

bool run_through_tets(const TetTable& table, std::span<const SensorRay> rays, const ContactSurface& surface,
                      int surface_number, CastBuffers& buffers, RayHits& hits) {
  return SurfaceCast(InTets(table), rays, surface, surface_number, buffers, hits).run();
}

void run_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                      int surface_number, CastBuffers& buffers, RayHits& hits) {
  SurfaceCast(InGrid(grid), rays, surface, surface_number, buffers, hits).run();
}

void run_through_tiles(const RayTiles& tiles, const TetTable* table, std::span<const SensorRay> rays,
                       const ContactSurface& surface, int surface_number, CastBuffers& buffers, RayHits& hits) {
  SurfaceCast(InTiles(tiles, table), rays, surface, surface_number, buffers, hits).run();
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_through_tets);
HWY_EXPORT(run_through_grid);
HWY_EXPORT(run_through_tiles);

bool cast_through_tets(const TetTable& table, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits) {
  return HWY_DYNAMIC_DISPATCH(run_through_tets)(table, rays, surface, surface_number, buffers, hits);
}

void cast_through_grid(const RayGrid& grid, std::span<const SensorRay> rays, const ContactSurface& surface,
                       int surface_number, CastBuffers& buffers, RayHits& hits) {
  HWY_DYNAMIC_DISPATCH(run_through_grid)(grid, rays, surface, surface_number, buffers, hits);
}

void cast_through_tiles(const RayTiles& tiles, const TetTable* table, std::span<const SensorRay> rays,
                        const ContactSurface& surface, int surface_number, CastBuffers& buffers, RayHits& hits) {
  HWY_DYNAMIC_DISPATCH(run_through_tiles)(tiles, table, rays, surface, surface_number, buffers, hits);
}
}  // namespace taxel
#endif
