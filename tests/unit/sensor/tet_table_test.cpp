// The tet table gives the hits of brute force and of the trees to the last bit, in random and in degenerate scenes.
#include "core/sensor/rays/tet_table.h"

#include <gtest/gtest.h>

#include "core/hydro/intersect.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/counted_new.h"
#include "fixtures/instruction_sets.h"
#include "unit/sensor/random_surface.h"
#include "unit/sensor/ray_scenes.h"

namespace taxel {
namespace {

// 10 000 sets of rays over 100 scenes of two objects.
TEST(TetTable, EqualsBruteForceAndTreesOnRandomSets) {
  constexpr int kScenes = 100, kSets = 100, kRays = 24;
  constexpr double size = RandomScenes::kSize;
  const RandomScenes scenes;
  long hits = 0, clear = 0, nodes_beside_bvh = 0, nodes = 0;
  for (int scene = 0; scene < kScenes; ++scene) {
    const HydroBodyPtr& body = scenes.body(scene);
    const std::vector<ContactSurface> surfaces = scenes.surfaces(scene);
    const auto list = pointers(surfaces);
    const WithoutTrees brute_force(list);
    AllPaths both;
    for (int set = 0; set < kSets; ++set) {
      const auto seed = static_cast<std::uint64_t>(kSets * scene + set);
      const SensorModel model = model_of(body, random_rays(surfaces, size, kRays, seed));
      both.cast(model, list);
      for (std::size_t r = 0; r < model.rays.size(); ++r) {
        const SensorRay& ray = model.rays[r];
        const RayHit expected = brute_force.cast(ray);
        ASSERT_TRUE(same(both.table.all()[r], expected)) << "table, scene " << scene << " set " << set << " ray " << r;
        ASSERT_TRUE(same(both.tiles.all()[r], expected)) << "tiles, scene " << scene << " set " << set << " ray " << r;
        ASSERT_TRUE(same(both.bvh.all()[r], expected)) << "bvh, scene " << scene << " set " << set << " ray " << r;
        hits += expected.hit();
        if (r % 4 < 2) continue;  // aimed at rims
        const OracleHit other = oracle(list, {ray.origin, ray.direction, ray.max_depth});
        if (other.margin < kRimUnclear * size) continue;
        ASSERT_EQ(expected.surface, other.hit.surface);
        ASSERT_EQ(expected.polygon, other.hit.polygon);
        ASSERT_NEAR(expected.depth, other.hit.depth, 1e-12);
        ++clear;
      }
    }
    nodes_beside_bvh += both.nodes_beside_bvh, nodes += both.nodes;
  }
  EXPECT_EQ(nodes_beside_bvh, 0) << "the table visits no node: there is none";
  EXPECT_GT(nodes, 10000);
  EXPECT_GT(hits, 50000);
  EXPECT_GT(clear, 20000);
}

// A soft box on a plane: the contact is divided along the faces between tets. Rays run exactly along these faces,
// through their edges and corners, and in the plane of the box's symmetry. In any pose, no ray passes between tets.
TEST(TetTable, LetsNoRayThroughBetweenTets) {
  const dvec3 half(0.02, 0.016, 0.01);
  const double depth = 0.003;
  const HydroBodyPtr body = soft(ShapeType::box, half, 0), plane = rigid(ShapeType::plane, dvec3(0));
  std::vector<SensorRay> rays;
  constexpr int kGrid = 32;
  for (int i = -kGrid; i <= kGrid; ++i) {
    for (int j = -kGrid; j <= kGrid; ++j) {
      const dvec3 from(half.x * i / kGrid, half.y * j / kGrid, -half.z);
      rays.push_back({static_cast<int>(rays.size()), from, dvec3(0, 0, 1), half.z});
    }
  }
  for (const dvec3& v : field_of(*body).vertices()) {  // towards the tets' own vertices, along their edges
    for (const double x : {-1.0, 0.0, 1.0}) {
      const dvec3 from(0.5 * half.x * x, 0, -half.z), to = v.z > -0.9 * half.z ? v : dvec3(v.x, v.y, 0) * 0.5;
      rays.push_back({static_cast<int>(rays.size()), from, glm::normalize(to - from), 4 * half.z});
    }
  }
  const SensorModel model = model_of(body, rays);
  AllPaths both;
  IntersectWorkspace workspace;
  for (int round = 0; round < 50; ++round) {
    std::vector<ContactSurface> surfaces(1);
    const Pose X_WA = round == 0 ? Pose{} : random_pose(5, round, 1.0);
    const Pose X_AB{dquat(1, 0, 0, 0), dvec3(0, 0, depth - half.z)};
    intersect(*body, *plane, X_WA, X_WA * X_AB, surfaces[0], workspace);
    ASSERT_GT(surfaces[0].polygons.size(), 3U);
    both.cast(model, pointers(surfaces));
    for (std::size_t r = 0; r < rays.size(); ++r) {
      ASSERT_TRUE(same(both.table.all()[r], both.bvh.all()[r]));
      ASSERT_TRUE(same(both.tiles.all()[r], both.bvh.all()[r]));
      const dvec3& d = rays[r].direction;
      const double t = depth / d.z;
      const dvec3 at = rays[r].origin + t * d;
      // p = 0 on the skin: the plane's section of the box is in contact up to its rim.
      if (std::abs(at.x) > (1 - 1e-7) * half.x || std::abs(at.y) > (1 - 1e-7) * half.y) continue;
      const RayHit& hit = both.table.all()[r];
      ASSERT_TRUE(hit.hit()) << "round " << round << " at " << at.x << " " << at.y;
      ASSERT_NEAR(hit.depth, t, 1e-12);
      const dvec3 away = half - glm::abs(at);
      const double nearest = std::min({away.x, away.y, depth});
      ASSERT_NEAR(hit.pressure, 1e5 * nearest / half.z, 1e-6);
    }
  }
}

TEST(TetTable, UsesTreesForSurfacesOutsideTheField) {
  const HydroBodyPtr body = soft(ShapeType::sphere, dvec3(0.02), 0.012);
  std::vector<ContactSurface> surfaces(2);
  IntersectWorkspace workspace;
  intersect(*body, *rigid(ShapeType::plane, dvec3(0)), Pose{}, Pose{dquat(1, 0, 0, 0), dvec3(0, 0, -0.015)},
            surfaces[0], workspace);
  add_polygon(surfaces[1], {dvec3(-0.01, -0.01, 0), dvec3(0.01, -0.01, 0), dvec3(0, 0.02, 0)}, 7.0, dvec3(0));
  const SensorModel model = model_of(body, {{0, dvec3(0, 0, -0.019), dvec3(0, 0, 1), 0.02},
                                            {1, dvec3(0, 0, 0.01), dvec3(0, 0, -1), 0.04},
                                            {2, dvec3(0.5, 0, 0.01), dvec3(0, 0, -1), 0.04}});
  CastWorkspace memory;
  RayHits hits;
  cast_rays(model, pointers(surfaces), RayPath::tet_table, memory, hits);
  EXPECT_EQ(hits[0].surface, 0) << "the nearer one, from the table";
  EXPECT_EQ(hits[1].surface, 1) << "the nearer one, from the trees";
  EXPECT_EQ(hits[1].pressure, 7.0);
  EXPECT_FALSE(hits[2].hit());
  EXPECT_EQ(hits.hit_rays(), (std::vector<std::int32_t>{0, 1}));
}

/// The finger of the project, pressed onto the edge of a box at several places.
struct Finger {
  static SensorModelPtr load() {
    static const SensorModelPtr model = load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
    return model;
  }
  SensorModelPtr model = load();
  std::vector<ContactSurface> surfaces;
  Finger() {
    const HydroBodyPtr box = rigid(ShapeType::box, dvec3(0.02));
    IntersectWorkspace workspace;
    const Aabb& bounds = model->mesh->bounds();
    for (int i = 0; i < 6; ++i) {
      Pose X_WB = random_pose(8, i, 0.001);
      const double reach = 0.5 * bounds.extent().y + 0.02 - 0.0012;
      X_WB.q = glm::angleAxis(0.3 * i, dvec3(0, 1, 0));
      X_WB.p += bounds.center() + dvec3(0, -reach, 0.002 * i);
      intersect(*model->body, *box, Pose{}, X_WB, surfaces.emplace_back(), workspace);
    }
  }
};

TEST(TetTable, GivesTheSameBitsAsTheTreesAfterAnyHistory) {
  const Finger f;
  SensorReading one, other;
  std::vector<std::vector<double>> first;
  double largest = 0;
  for (const ContactSurface& surface : f.surfaces) {
    const ContactSurface* list[] = {&surface};
    read_sensor(*f.model, list, one, RayPath::tet_table);
    read_sensor(*f.model, list, other, RayPath::bvh);
    ASSERT_EQ(one.values, other.values);
    ASSERT_EQ(one.hits.hit_rays(), other.hits.hit_rays());
    ASSERT_GT(one.hits.hit_rays().size(), 50U);
    first.push_back(one.values);
    largest = std::max(largest, *std::max_element(one.values.begin(), one.values.end()));
  }
  EXPECT_GT(largest, 1000.0);
  for (std::size_t i = f.surfaces.size(); i-- > 0;) {
    const ContactSurface* list[] = {&f.surfaces[i]};
    read_sensor(*f.model, list, one);
    EXPECT_EQ(one.values, first[i]);
  }
  read_sensor(*f.model, {}, one);
  EXPECT_EQ(one.values, std::vector<double>(first[0].size(), 0.0));
  EXPECT_TRUE(std::none_of(one.hits.all().begin(), one.hits.all().end(), [](const RayHit& h) { return h.hit(); }));
}

TEST(TetTable, GivesTheSameHitsOnAllInstructionSets) {
  const Finger f;
  const auto list = pointers(f.surfaces);
  const WithoutTrees brute_force(list);
  CastWorkspace workspace;
  test::for_each_set([&](std::int64_t target) {
    RayHits hits;
    test::on_target(target, [&] {
      cast_rays(*f.model, list, RayPath::tet_table, workspace, hits);
      return 0;
    });
    for (std::size_t r = 0; r < f.model->rays.size(); r += 3)
      ASSERT_TRUE(same(hits.all()[r], brute_force.cast(f.model->rays[r]))) << "set " << target << " ray " << r;
    EXPECT_GT(hits.hit_rays().size(), 500U);
  });
}

TEST(TetTable, AllocatesNothingAfterTheFirstStep) {
  const Finger f;
  SensorReading reading;
  const ContactSurface* all[] = {&f.surfaces[0], &f.surfaces[1], &f.surfaces[2]};
  read_sensor(*f.model, all, reading);
  const long before = allocation_count();
  for (const ContactSurface& surface : f.surfaces) {
    const ContactSurface* list[] = {&surface};
    read_sensor(*f.model, list, reading);
    read_sensor(*f.model, all, reading);
  }
  EXPECT_EQ(allocation_count() - before, 0);
}

}  // namespace
}  // namespace taxel
