// The raster path for flat arrays gives the hits of brute force, trees and tet table to the last bit, in random and in
// degenerate scenes.
#include "core/sensor/rays/ray_grid.h"

#include <gtest/gtest.h>

#include <map>

#include "core/hydro/intersect.h"
#include "core/layout/sensor_presets.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/random_surface.h"
#include "unit/sensor/ray_scenes.h"

namespace taxel {
namespace {

/// A sequence of random numbers.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : rng_(seed) {}
  double uniform() { return rng_.uniform(next_++); }
  std::size_t pick(std::size_t n) { return static_cast<std::size_t>(uniform() * static_cast<double>(n)); }
  dvec3 vector() {
    const double x = uniform(), y = uniform(), z = uniform();
    return dvec3(x, y, z) - 0.5;
  }

 private:
  CounterRng rng_;
  std::uint64_t next_ = 0;
};

/// Returns a direction: any, along an axis, along a polygon's normal, in its plane, or along one of its edges.
dvec3 shared_direction(const ContactSurface& surface, int set, Dice& dice) {
  const ContactPolygon& polygon = surface.polygons[dice.pick(surface.polygons.size())];
  const dvec3* corner = surface.vertices.data() + polygon.first;
  const double sign = dice.uniform() < 0.5 ? -1.0 : 1.0;
  dvec3 axis(0);
  axis[set % 3] = sign;
  switch (set % 5) {
    case 0:
      return axis;
    case 1:
      return sign * polygon.normal;
    case 2:
      return any_perpendicular(polygon.normal);
    case 3:
      return glm::normalize(corner[1] - corner[0]);
    default:
      return glm::normalize(dice.vector());
  }
}

/// Returns segments of one direction around the contact. Some aim at corners, some at middles of edges, and some start
/// where another one does. In every fourth set the directions differ by rounding.
std::vector<SensorRay> parallel_rays(const std::vector<ContactSurface>& surfaces, double size, int count, int set,
                                     Dice& dice) {
  std::vector<SensorRay> rays;
  const ContactSurface& any = surfaces[surfaces[0].empty() ? 1 : 0];
  if (any.empty()) return rays;
  const dvec3 direction = shared_direction(any, set, dice);
  for (int i = 0; i < count; ++i) {
    const ContactSurface& surface = surfaces[dice.pick(surfaces.size())];
    if (surface.empty()) continue;
    const ContactPolygon& polygon = surface.polygons[dice.pick(surface.polygons.size())];
    const std::size_t k = dice.pick(static_cast<std::size_t>(polygon.count));
    const dvec3 aim = aim_of(i, surface, polygon, k, polygon.centroid + size * 0.5 * dice.vector());
    dvec3 from = aim - (0.6 * size * dice.uniform()) * direction;
    if (i % 8 == 7 && !rays.empty()) from = rays.back().origin;
    const dvec3 noise = set % 4 == 3 ? 1e-16 * dice.vector() : dvec3(0);
    rays.push_back({i, from, direction + noise, dice.uniform() * size});
  }
  return rays;
}

// 10 000 sets of rays over 100 scenes of two objects. A third of the second objects are copies of the first, which
// gives ties.
TEST(RayGrid, EqualsBruteForceTreesAndTetTableOnRandomSets) {
  constexpr int kScenes = 100, kSets = 100, kRays = 24;
  constexpr double size = RandomScenes::kSize;
  const RandomScenes scenes;
  long hits = 0, nodes_beside_bvh = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    const HydroBodyPtr& body = scenes.body(scene);
    std::vector<ContactSurface> surfaces = scenes.surfaces(scene);
    if (scene % 3 == 0) surfaces[1] = surfaces[0];
    const auto list = pointers(surfaces);
    const WithoutTrees brute_force(list);
    AllPaths paths;
    Dice dice(static_cast<std::uint64_t>(scene));
    for (int set = 0; set < kSets; ++set) {
      SensorModel model = model_of(body, parallel_rays(surfaces, size, kRays, set, dice));
      if (model.rays.empty()) continue;
      model.ray_tables.grid = RayGrid::make(model.rays);
      ASSERT_TRUE(model.ray_tables.grid) << "scene " << scene << " set " << set;
      paths.cast(model, list);
      for (std::size_t r = 0; r < model.rays.size(); ++r) {
        const RayHit expected = brute_force.cast(model.rays[r]);
        ASSERT_TRUE(same(paths.raster.all()[r], expected)) << "scene " << scene << " set " << set << " ray " << r;
        ASSERT_TRUE(same(paths.table.all()[r], expected)) << "table, scene " << scene << " set " << set << " ray " << r;
        ASSERT_TRUE(same(paths.tiles.all()[r], expected)) << "tiles, scene " << scene << " set " << set << " ray " << r;
        ASSERT_TRUE(same(paths.bvh.all()[r], expected)) << "bvh, scene " << scene << " set " << set << " ray " << r;
        hits += expected.hit();
      }
      ASSERT_EQ(paths.raster.hit_rays(), paths.bvh.hit_rays());
    }
    nodes_beside_bvh += paths.nodes_beside_bvh;
  }
  EXPECT_GT(hits, 30000);
  EXPECT_EQ(nodes_beside_bvh, 0);
}

/// Casts rays by the raster path and by brute force, on surfaces without tets.
void expect_as_brute_force(const std::vector<SensorRay>& rays, const std::vector<ContactSurface>& surfaces,
                           long* hits = nullptr) {
  SensorModel model;
  model.rays = rays;
  model.ray_tables.grid = RayGrid::make(rays);
  ASSERT_TRUE(model.ray_tables.grid);
  CastWorkspace workspace;
  RayHits found;
  cast_rays(model, pointers(surfaces), RayPath::raster, workspace, found);
  EXPECT_TRUE(workspace.caster->empty());
  const WithoutTrees brute_force(pointers(surfaces));
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const RayHit expected = brute_force.cast(rays[r]);
    ASSERT_TRUE(same(found.all()[r], expected)) << "ray " << r;
    if (hits) *hits += expected.hit();
  }
}

TEST(RayGrid, EqualsBruteForceForAnySpreadOfRays) {
  long hits = 0;
  for (int round = 0; round < 400; ++round) {
    Dice dice(static_cast<std::uint64_t>(1000 + round));
    const std::vector<ContactSurface> surfaces{random_surface(60, 0.15, static_cast<std::uint64_t>(round)),
                                               random_surface(40, round % 2 ? 0.02 : 2.0, 9)};
    const dvec3 direction = glm::normalize(dice.vector()), across = any_perpendicular(direction);
    std::vector<SensorRay> rays;
    const int count = round % 10 == 0 ? 1 : 200;
    const dvec3 middle = dvec3(0.5) + 0.2 * dice.vector();
    for (int i = 0; i < count; ++i) {
      dvec3 from = dvec3(0.5) + dice.vector();                                  // anywhere
      if (round % 5 == 1) from = middle + dice.uniform() * across;              // on a line
      if (round % 5 == 2) from = middle;                                        // at one point
      if (round % 5 == 3) from = middle + 1e-9 * dice.vector();                 // near one point
      if (round % 5 == 4) from = middle + dvec3(i % 2) + 0.01 * dice.vector();  // in two clusters far apart
      rays.push_back({i, from, direction, dice.uniform()});
    }
    expect_as_brute_force(rays, surfaces, &hits);
  }
  EXPECT_GT(hits, 5000);
}

/// Returns a wall of squares in the plane x = 0.25, and a floor in the plane z = 0.25.
std::vector<ContactSurface> wall_and_floor() {
  std::vector<ContactSurface> surfaces(2);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      const double a = 0.1 * i, b = 0.1 * j, a1 = 0.1 * (i + 1), b1 = 0.1 * (j + 1);
      add_polygon(surfaces[0], {dvec3(0.25, a, b), dvec3(0.25, a1, b), dvec3(0.25, a1, b1), dvec3(0.25, a, b1)}, 5.0,
                  dvec3(0, 1, 2));
      add_polygon(surfaces[1], {dvec3(a, b, 0.25), dvec3(a1, b, 0.25), dvec3(a1, b1, 0.25), dvec3(a, b1, 0.25)}, 5.0,
                  dvec3(1, 2, 0));
    }
  return surfaces;
}

// Rays through shared edges and corners of the floor, and in the plane of the wall, exactly and slightly off it.
TEST(RayGrid, EqualsBruteForceAtEdgesCornersAndEdgeOnWalls) {
  std::vector<SensorRay> rays;
  for (const double tilt : {0.0, 1e-10})
    for (int j = -1; j <= 17; ++j)
      for (int i = -1; i <= 17; ++i)
        for (const double depth : {0.2, 0.25, 1.0})
          rays.push_back({0, dvec3(0.05 * i, 0.05 * j, 0), dvec3(tilt, 0, 1), depth});
  const std::vector<ContactSurface> surfaces = wall_and_floor();
  long hits = 0;
  expect_as_brute_force(rays, surfaces, &hits);
  EXPECT_GE(hits, 2 * 2 * 17 * 17) << "every one within the floor that is long enough, rims included";
  for (SensorRay& ray : rays) ray.origin.z = 0.25;
  expect_as_brute_force(rays, surfaces);
  for (SensorRay& ray : rays) ray.direction = dvec3(1, 0, 0);
  expect_as_brute_force(rays, surfaces);
}

// A polygon that covers the whole grid and extends far beyond it, and one far away.
TEST(RayGrid, EqualsBruteForceForLargeAndFarPolygons) {
  std::vector<ContactSurface> surfaces(1);
  add_polygon(surfaces[0], {dvec3(-1e6, -1e6, 0), dvec3(1e6, -1e6, 0), dvec3(0, 2e6, 0)}, 5.0, dvec3(0));
  add_polygon(surfaces[0], {dvec3(1e9, 0, 0), dvec3(1e9, 1, 0), dvec3(1e9 - 1, 0, 0)}, 5.0, dvec3(0));
  std::vector<SensorRay> rays;
  for (int i = 0; i < 100; ++i) rays.push_back({i, dvec3(0.001 * i, 0.002 * (i % 7), 0.001), dvec3(0, 0, -1), 0.002});
  long hits = 0;
  expect_as_brute_force(rays, surfaces, &hits);
  EXPECT_EQ(hits, 100);
}

TEST(RayGrid, ExistsOnlyForRaysOfOneDirection) {
  std::vector<SensorRay> rays{{0, dvec3(0), dvec3(0, 0, 1), 1.0}, {1, dvec3(1, 0, 0), dvec3(0, 0, 1), 1.0}};
  EXPECT_TRUE(RayGrid::make(rays));
  rays[1].direction = glm::normalize(dvec3(1e-7, 0, 1));
  EXPECT_FALSE(RayGrid::make(rays));
  EXPECT_FALSE(RayGrid::make({}));
}

// A polygon tests only the rays of the cells that it covers.
TEST(RayGrid, VisitsTheCellsUnderAPolygon) {
  std::vector<SensorRay> rays;
  for (int i = 0; i < 10000; ++i)
    rays.push_back({i, dvec3(0.01 * (i % 100), 0.01 * (i / 100), 0), dvec3(0, 0, 1), 1.0});
  const auto grid = RayGrid::make(rays);
  EXPECT_LE(grid->cell_count(), 2 * rays.size());
  const auto visited = [&](double from, double size, double z) {
    ContactSurface surface;
    add_polygon(surface, {dvec3(from, from, z), dvec3(from + size, from, z), dvec3(from, from + size, z)}, 0.0,
                dvec3(0));
    std::size_t lanes = 0;
    grid->visit(surface, surface.polygons[0], [&](std::size_t first, std::size_t last) { lanes += last - first; });
    return lanes;
  };
  EXPECT_GE(visited(0.301, 0.1, 0.5), 50U);
  EXPECT_LE(visited(0.301, 0.1, 0.5), 300U);
  EXPECT_EQ(visited(0.301, 0.1, 1.5), 0U) << "too deep";
  EXPECT_EQ(visited(2.0, 0.1, 0.5), 0U) << "next to the polygon";
  EXPECT_EQ(visited(-1.0, 4.0, 0.5), 10000U);
}

/// A flat array of the presets, pressed by a ball.
struct FlatArray {
  SensorModelPtr model;
  std::vector<ContactSurface> surfaces{2};
  explicit FlatArray(double density) {
    SensorPreset preset = make_sensor_preset("xela-4x4");
    preset.layout.sampling.density = density;
    model = build_sensor_model(preset.layout, preset.mesh, "", "xela-4x4");
    const HydroBodyPtr ball = rigid(ShapeType::sphere, dvec3(0.008));
    IntersectWorkspace workspace;
    const double top = preset.mesh->bounds().hi.z;
    for (std::size_t i = 0; i < 2; ++i) {
      const Pose X_MB{dquat(1, 0, 0, 0), dvec3(0.006 * static_cast<double>(i) - 0.002, 0.001, top + 0.007)};
      intersect(*model->body, *ball, Pose{}, X_MB, surfaces[i], workspace);
    }
  }
};

TEST(RayGrid, IsUsedForFlatArraysAndGivesTheSameReadings) {
  const FlatArray f(2e6);
  ASSERT_TRUE(f.model->ray_tables.grid);
  EXPECT_FALSE(load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json")->ray_tables.grid);
  std::map<RayPath, std::vector<double>> values;
  std::map<RayPath, std::size_t> nodes;
  for (const RayPath path : {RayPath::fastest, RayPath::bvh, RayPath::tet_table, RayPath::raster}) {
    SensorReading reading;
    read_sensor(*f.model, pointers(f.surfaces), reading, path);
    values[path] = reading.values;
    nodes[path] = reading.workspace.caster->node_count();
  }
  const std::vector<double>& fastest = values[RayPath::fastest];
  EXPECT_GT(*std::max_element(fastest.begin(), fastest.end()), 1000.0);
  for (const auto& [path, found] : values) {
    EXPECT_EQ(found, fastest);
    EXPECT_EQ(nodes[path] > 0, path == RayPath::bvh);
  }
}

TEST(RayGrid, AllocatesNothingAfterTheFirstStep) {
  const FlatArray f(2e6);
  const auto list = pointers(f.surfaces);
  SensorReading reading;
  read_sensor(*f.model, list, reading);
  const long before = allocation_count();
  for (int i = 0; i < 3; ++i) read_sensor(*f.model, list, reading);
  EXPECT_EQ(allocation_count() - before, 0);
}

}  // namespace
}  // namespace taxel
