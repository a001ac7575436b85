// Rays on contact surfaces, compared with brute force: every ray with every polygon, by formulas that differ from the
// caster's.
#include "core/sensor/rays/cast_rays.h"

#include <gtest/gtest.h>

#include "core/sensor/rays/surface_caster.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/random_surface.h"
#include "unit/sensor/ray_oracles.h"

namespace taxel {
namespace {

Ray random_ray(const CounterRng& rng, std::uint64_t i) {
  const dvec3 from(rng.uniform(8 * i), rng.uniform(8 * i + 1), rng.uniform(8 * i + 2));
  const dvec3 to(rng.uniform(8 * i + 3), rng.uniform(8 * i + 4), rng.uniform(8 * i + 5));
  return {from, glm::normalize(to - from), 1.5 * rng.uniform(8 * i + 6)};
}

TEST(CastRays, EqualsBruteForceOnRandomSurfaces) {
  int hits = 0, limited = 0;
  for (std::uint64_t round = 0; round < 12; ++round) {
    std::vector<ContactSurface> surfaces;
    for (std::uint64_t s = 0; s < 1 + round % 4; ++s)
      surfaces.push_back(random_surface(static_cast<int>(20 + 60 * round), 0.1, 100 * round + s));
    if (round == 7) surfaces[1] = ContactSurface{};
    SurfaceCaster caster;
    caster.build(pointers(surfaces));
    const CounterRng rng(77, round);
    for (std::uint64_t i = 0; i < 1500; ++i) {
      const Ray ray = random_ray(rng, i);
      const RayHit hit = caster.cast(ray.origin, ray.direction, ray.t_max);
      const OracleHit expected = oracle(pointers(surfaces), ray);
      if (expected.margin < kRimUnclear) continue;  // on a rim: both results are correct
      ASSERT_EQ(hit.surface, expected.hit.surface) << round << " " << i;
      ASSERT_EQ(hit.polygon, expected.hit.polygon) << round << " " << i;
      ASSERT_NEAR(hit.depth, expected.hit.depth, 1e-12);
      ASSERT_NEAR(hit.pressure, expected.hit.pressure, 1e-12 * 1e6 * 10);
      hits += hit.hit();
      limited += !hit.hit() && caster.cast(ray.origin, ray.direction, 10.0).hit();
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(limited, 300) << "the depth limit is exercised";
}

// Tests every polygon without trees. The hits are equal to the last bit, including ties.
TEST(CastRays, GivesTheSameHitsWithoutTrees) {
  std::vector<ContactSurface> surfaces = {random_surface(300, 0.15, 5), random_surface(200, 0.15, 6)};
  surfaces.push_back(surfaces[0]);  // every hit on the first surface is a tie
  SurfaceCaster caster;
  caster.build(pointers(surfaces));
  const WithoutTrees brute_force(pointers(surfaces));
  const CounterRng rng(9);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Ray ray = random_ray(rng, i);
    if (i % 4 == 0) ray.direction = dvec3(0, 0, i % 8 == 0 ? 1 : -1);
    const RayHit expected = brute_force.cast({0, ray.origin, ray.direction, ray.t_max});
    const RayHit hit = caster.cast(ray.origin, ray.direction, ray.t_max);
    ASSERT_EQ(hit.surface, expected.surface);
    ASSERT_EQ(hit.polygon, expected.polygon);
    ASSERT_EQ(hit.depth, expected.depth);
    ASSERT_EQ(hit.pressure, expected.pressure);
    ASSERT_NE(hit.surface, 2);
  }
}

/// Returns a plate of n x n squares in the plane z = height.
ContactSurface plate(int n, double height) {
  ContactSurface surface;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = 0.1 * i, y = 0.1 * j, x1 = 0.1 * (i + 1), y1 = 0.1 * (j + 1);
      add_polygon(surface, {dvec3(x, y, height), dvec3(x1, y, height), dvec3(x1, y1, height), dvec3(x, y1, height)},
                  5.0, dvec3(1, 2, 0));
    }
  return surface;
}

// Flat, axis-aligned boxes and rays through shared edges and corners: no ray passes between polygons, and the polygon
// with the lowest number is the hit.
TEST(CastRays, HitsSharedEdgesAndCornersOnce) {
  const std::vector<ContactSurface> surfaces = {plate(8, 0.25), plate(8, 0.25), plate(8, 0.5)};
  SurfaceCaster caster;
  caster.build(pointers(surfaces));
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 8; ++i)
      for (const double dx : {0.0, 0.05})
        for (const double dy : {0.0, 0.05}) {
          if (dx > 0 && i == 8) continue;
          if (dy > 0 && j == 8) continue;
          const dvec3 origin(0.1 * i + dx, 0.1 * j + dy, 0.0);
          const RayHit hit = caster.cast(origin, dvec3(0, 0, 1), 1.0);
          ASSERT_EQ(hit.surface, 0) << i << " " << j;
          const int lowest_i = dx > 0 ? i : std::max(0, i - 1), lowest_j = dy > 0 ? j : std::max(0, j - 1);
          ASSERT_EQ(hit.polygon, 8 * lowest_j + lowest_i);
          ASSERT_DOUBLE_EQ(hit.depth, 0.25);
          ASSERT_NEAR(hit.pressure, 5.0 + origin.x + 2.0 * origin.y, 1e-14);
        }
}

TEST(CastRays, IncludesItsDepthLimits) {
  const std::vector<ContactSurface> surfaces = {plate(1, 0.25)};
  SurfaceCaster caster;
  caster.build(pointers(surfaces));
  const dvec3 at(0.03, 0.04, 0.0), up(0, 0, 1);
  EXPECT_TRUE(caster.cast(at, up, 0.25).hit());
  EXPECT_FALSE(caster.cast(at, up, std::nextafter(0.25, 0.0)).hit());
  EXPECT_TRUE(caster.cast(at + 0.25 * up, up, 0.0).hit());
  EXPECT_TRUE(caster.cast(at + 0.25 * up, -up, 0.0).hit());
  EXPECT_FALSE(caster.cast(at, -up, 1.0).hit());
  EXPECT_FALSE(caster.cast(at, dvec3(1, 0, 0), 1.0).hit()) << "parallel";
  EXPECT_EQ(caster.cast(at, -up, 1.0).pressure, 0.0);
}

TEST(CastRays, FindsNoHitWithoutSurfaces) {
  SurfaceCaster caster;
  EXPECT_FALSE(caster.cast(dvec3(0), dvec3(0, 0, 1), 1.0).hit());
  caster.build({});
  EXPECT_FALSE(caster.cast(dvec3(0), dvec3(0, 0, 1), 1.0).hit());
  const ContactSurface empty;
  const std::vector<const ContactSurface*> list = {nullptr, &empty};
  caster.build(list);
  EXPECT_FALSE(caster.cast(dvec3(0), dvec3(0, 0, 1), 1.0).hit());
  EXPECT_FALSE(caster.may_hit(dvec3(0), dvec3(0, 0, 1)));
}

TEST(CastRays, AllocatesNothingAfterTheFirstStep) {
  SensorModel model;
  const CounterRng rng(4);
  for (int i = 0; i < 500; ++i) {
    const Ray ray = random_ray(rng, static_cast<std::uint64_t>(i));
    model.rays.push_back({i, ray.origin, ray.direction, ray.t_max});
  }
  const std::vector<ContactSurface> large = {random_surface(300, 0.1, 1), random_surface(300, 0.1, 2)};
  const std::vector<ContactSurface> small = {random_surface(100, 0.1, 3), ContactSurface{}};
  const auto large_list = pointers(large), small_list = pointers(small);
  CastWorkspace workspace;
  RayHits hits;
  cast_rays(model, large_list, RayPath::bvh, workspace, hits);
  const std::vector<RayHit> first = hits.all();
  const long before = allocation_count();
  cast_rays(model, small_list, RayPath::bvh, workspace, hits);
  cast_rays(model, large_list, RayPath::bvh, workspace, hits);
  EXPECT_EQ(allocation_count() - before, 0);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(hits.all()[i].depth, first[i].depth);
}

// The early exit of cast_rays excludes only rays that miss.
TEST(CastRays, CastsAllRaysOfAModel) {
  const std::vector<ContactSurface> surfaces = {random_surface(30, 0.05, 12)};
  SurfaceCaster caster;
  caster.build(pointers(surfaces));
  SensorModel model;
  const CounterRng rng(14);
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = random_ray(rng, static_cast<std::uint64_t>(i));
    model.rays.push_back({i, ray.origin, ray.direction, 0.3 * ray.t_max});
  }
  CastWorkspace workspace;
  RayHits hits;
  hits.clear(7);
  cast_rays(model, pointers(surfaces), RayPath::bvh, workspace, hits);
  ASSERT_EQ(hits.all().size(), model.rays.size());
  std::vector<std::int32_t> hit_rays;
  for (std::size_t i = 0; i < model.rays.size(); ++i) {
    const RayHit alone = caster.cast(model.rays[i].origin, model.rays[i].direction, model.rays[i].max_depth);
    ASSERT_EQ(hits.all()[i].polygon, alone.polygon);
    ASSERT_EQ(hits.all()[i].depth, alone.depth);
    if (alone.hit()) hit_rays.push_back(static_cast<std::int32_t>(i));
  }
  EXPECT_EQ(hits.hit_rays(), hit_rays);
}

}  // namespace
}  // namespace taxel
