// A recorded run played as a path: the pose of the finger relative to the object is that of the run.
#include "core/document/scenario/path.h"

#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/scenario_scene.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

/// Centre and half edges of the object's geom, in the world [m].
struct Box {
  dvec3 center, half;
};
Box object_of(const ScenarioScene& scene) {
  register_sensor_plugin();
  const CompiledScene compiled = compile_scene(scene.hosted_xml, scene.files.files, "path");
  const int g = mj_name2id(compiled.model.get(), mjOBJ_GEOM, kObjectGeom);
  const mjModel& m = *compiled.model;
  return {dvec3(m.geom_pos[3 * g], m.geom_pos[3 * g + 1], m.geom_pos[3 * g + 2]),
          dvec3(m.geom_size[3 * g], m.geom_size[3 * g + 1], m.geom_size[3 * g + 2])};
}

std::vector<WayPoint> points_of(const ScenarioScene& scene) {
  std::vector<WayPoint> points;
  for (std::uint64_t step = 0; step <= scene.motion.last_step; step += 500)
    points.push_back({static_cast<double>(step) * scene.motion.timestep, scene.motion.pose(step)});
  return points;
}

TEST(RecordedPath, KeepsThePapersFingerAtItsPlaceOnTheBox) {
  const SensorModelPtr model = test::fingertip_model(1e5);
  const Scenario paper = default_scenario(kKind<scenarios::Paper>);
  const ScenarioScene run = build_scenario_scene(*model, paper);
  const std::vector<WayPoint> recorded = points_of(run);
  const Scenario path = path_of_run(paper, paper, recorded);
  EXPECT_EQ(path.kind(), kKind<scenarios::Path>);
  const ScenarioScene played = build_scenario_scene(*model, path);
  const Box before = object_of(run), after = object_of(played);
  EXPECT_LT(glm::distance(before.half, after.half), 1e-9);
  ASSERT_EQ(path.as<scenarios::Path>().points.size(), recorded.size());
  ASSERT_GT(recorded.size(), 10U);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const auto step = static_cast<std::uint64_t>(std::lround(recorded[i].time / played.motion.timestep));
    const Pose now = played.motion.pose(step);
    EXPECT_LT(glm::distance(now.p - after.center, recorded[i].X_WM.p - before.center), 1e-9) << i;
    EXPECT_LT(glm::length(now.q - recorded[i].X_WM.q), 1e-9) << i;
  }
}

TEST(RecordedPath, ReplacesThePapersObjectByThatOfTheRun) {
  Scenario run = with_shape(default_scenario(kKind<scenarios::Press>), ObjectShape::plate);
  run.box_size = 0.08;
  const std::vector<WayPoint> points{{0, {}}, {1, Pose{dquat(1, 0, 0, 0), dvec3(1, 2, 3)}}};
  const Scenario path = path_of_run(default_scenario(kKind<scenarios::Paper>), run, points);
  EXPECT_EQ(path.shape, ObjectShape::plate);
  EXPECT_EQ(path.box_size, 0.08);
  EXPECT_EQ(path.as<scenarios::Path>().points, points);
  const Scenario sphere = with_shape(run, ObjectShape::sphere), sweep;
  EXPECT_EQ(path_of_run(sphere, run, points).shape, ObjectShape::sphere) << "an object that was chosen stays";
  EXPECT_EQ(path_of_run(sweep, sweep, points).shape, ObjectShape::edge) << "the edge of the sweep stays";
}

}  // namespace
}  // namespace taxel
