// Readings of an object that is pressed deeper than the tets of the pad reach.
#include <gtest/gtest.h>

#include "core/hydro/intersect.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/ray_scenes.h"

namespace taxel {
namespace {

/// A rigid ball below the finger's pad, moved along the finger by `along`. Its lowest point is `depth` below the skin.
struct PressedFinger {
  SensorModelPtr model = load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
  HydroBodyPtr ball = make_body({ShapeType::sphere, dvec3(0.006, 0, 0), nullptr, 0.001}, Material{}, "object");
  IntersectWorkspace workspace;
  ContactSurface surface;

  void press(double along, double depth) {
    const Aabb& bounds = model->mesh->bounds();
    const Pose X{dquat(1, 0, 0, 0), dvec3(0.001, bounds.lo.y - 0.006 + depth, 0.012 + along)};
    intersect(*model->body, *ball, Pose{}, X, surface, workspace);
  }
  [[nodiscard]] int pieces() const {
    return static_cast<int>(std::count_if(surface.polygons.begin(), surface.polygons.end(),
                                          [](const ContactPolygon& p) { return p.tet < 0; }));
  }
};

TEST(DepthReadings, AreEqualForPiecesOnAllPaths) {
  PressedFinger finger;
  for (const double depth : {0.0023, 0.003, 0.0038}) {
    finger.press(0, depth);
    ASSERT_GT(finger.pieces(), 30);
    const ContactSurface* list[] = {&finger.surface};
    SensorReading table, tiles, trees;
    read_sensor(*finger.model, list, table, RayPath::tet_table);
    read_sensor(*finger.model, list, tiles, RayPath::tiles);
    read_sensor(*finger.model, list, trees, RayPath::bvh);
    ASSERT_EQ(table.values, trees.values);
    ASSERT_EQ(tiles.values, trees.values);
    ASSERT_EQ(table.hits.hit_rays(), trees.hits.hit_rays());
    int on_pieces = 0, on_tets = 0;
    for (const std::int32_t r : table.hits.hit_rays()) {
      const RayHit& hit = table.hits[static_cast<std::size_t>(r)];
      EXPECT_TRUE(same(hit, trees.hits[static_cast<std::size_t>(r)]));
      (finger.surface.polygons[static_cast<std::size_t>(hit.polygon)].tet < 0 ? on_pieces : on_tets) += 1;
    }
    EXPECT_GT(on_pieces, 50);
    EXPECT_GT(on_tets, 100);
  }
}

/// The rays below a pressed ball hit its lower half without a gap: the deepest reading is (E/H) times the depth.
TEST(DepthReadings, GrowWithDepth) {
  PressedFinger finger;
  double before = 0;
  for (double depth = 0.0005; depth < 0.0038; depth += 0.0001) {
    finger.press(0, depth);
    const ContactSurface* list[] = {&finger.surface};
    SensorReading reading;
    read_sensor(*finger.model, list, reading);
    double largest = 0;
    for (const std::int32_t r : reading.hits.hit_rays())
      largest = std::max(largest, reading.hits[static_cast<std::size_t>(r)].pressure);
    // The skin falls away next to the lowest point of the finger, so the ball is 0.114 mm less deep.
    EXPECT_NEAR(largest, 5e4 * (depth - 0.000114) / 0.002, 0.01 * 5e4);
    EXPECT_GT(*std::max_element(reading.values.begin(), reading.values.end()), before);
    before = *std::max_element(reading.values.begin(), reading.values.end());
  }
}

/// Slides by 10 micrometres at the depth where tets end and pieces begin, and deeper.
TEST(DepthReadings, DoNotJumpWhereTheTetsEnd) {
  PressedFinger finger;
  const SensorModelPtr model = with_readout(*finger.model, {.aggregate = Aggregate::force});
  for (const double depth : {0.00215, 0.0026}) {
    const int steps = 150;
    std::vector<std::vector<double>> readings;
    int fewest = 1 << 30, most = 0;
    SensorReading reading;
    for (int i = 0; i < steps; ++i) {
      finger.press(1e-5 * i, depth);
      fewest = std::min(fewest, finger.pieces());
      most = std::max(most, finger.pieces());
      const ContactSurface* list[] = {&finger.surface};
      read_sensor(*model, list, reading);
      readings.push_back(reading.values);
    }
    EXPECT_GT(most, fewest);
    for (std::size_t k = 0; k < readings[0].size(); ++k) {
      double peak = 0, jump = 0;
      for (std::size_t i = 0; i < readings.size(); ++i) {
        peak = std::max(peak, readings[i][k]);
        if (i > 0) jump = std::max(jump, std::abs(readings[i][k] - readings[i - 1][k]));
      }
      if (peak < 1e-3) continue;  // in newtons
      EXPECT_LE(jump, 0.01 * peak) << "taxel " << k << " at " << depth;
      RecordProperty("jump", std::to_string(jump / peak));
    }
  }
}

TEST(DepthReadings, AllocateNothingAfterTheFirstStep) {
  PressedFinger finger;
  SensorReading reading;
  const auto run = [&] {
    for (const double depth : {0.003, 0.0025, 0.001}) {
      finger.press(0, depth);
      const ContactSurface* list[] = {&finger.surface};
      read_sensor(*finger.model, list, reading);
    }
  };
  run();
  const long before = allocation_count();
  run();
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace taxel
