// Facts over the 3-D view: polygons that were left out, and the state of the scene.
#include <gtest/gtest.h>

#include "app/studio/nouns/view/view_panel.h"
#include "app/studio/nouns/view/view_state.h"

namespace taxel::ui {
namespace {

/// A scene of one geom and one moving body at step 50 of 2 ms.
struct StepFifty {
  std::shared_ptr<SimScene> scene = std::make_shared<SimScene>();
  std::shared_ptr<SimFrame> frame = std::make_shared<SimFrame>();
  RunView run;
  StepFifty() {
    scene->geoms.resize(1);
    scene->timestep = 0.002;
    scene->marks.dofs = 6;
    scene->marks.solver = "Newton";
    scene->marks.arena = 2000;
    frame->scene = scene;
    frame->step = 50;
    frame->time = 0.1;
    frame->mark_poses.bodies.resize(2);  // the world is the first one
    run.frame = frame;
  }
  /// The text of a row; empty if there is none.
  [[nodiscard]] std::string row(const std::string& name) const {
    for (const InfoRow& info : scene_info(run))
      if (info.name == name) return info.value;
    return "";
  }
};

TEST(LeftOut, AddsUpTheSurfacesOfASensor) {
  SensorStep sensor;
  sensor.surfaces.resize(2);
  sensor.surfaces[0].rejected[0] = {2, 1e-6, 0.5};
  sensor.surfaces[1].rejected[0] = {3, 2e-6, 0.25};
  sensor.surfaces[1].rejected[1] = {1, 4e-6, 0};
  const auto sums = left_out(sensor);
  EXPECT_EQ(sums[0].count, 5);
  EXPECT_NEAR(sums[0].area, 3e-6, 1e-18);
  EXPECT_EQ(sums[0].force, 0.75);
  EXPECT_EQ(sums[1].count, 1);
  EXPECT_EQ(sums[2].count, 0);
}

TEST(SceneInfo, IsEmptyWithoutAScene) {
  EXPECT_TRUE(scene_info({}).empty());
}

TEST(SceneInfo, GivesTimeStepAndSize) {
  StepFifty fifty;
  EXPECT_EQ(fifty.row("Time"), "0.1000 s, step 50 of 2 ms");
  EXPECT_EQ(fifty.row("Size"), "1 body, 1 geom, 6 DOFs") << "without the world";
  fifty.frame->mark_poses.bodies.resize(3);
  fifty.scene->geoms.resize(2);
  EXPECT_EQ(fifty.row("Size"), "2 bodies, 2 geoms, 6 DOFs");
}

TEST(SceneInfo, GivesThePaceOnceAStepWasMeasured) {
  StepFifty fifty;
  EXPECT_EQ(fifty.row("Pace"), "");
  fifty.run.performance.step_seconds = 2.5e-4;
  fifty.run.performance.simulation_speed = 0.5;
  EXPECT_EQ(fifty.row("Pace"), "250 \u00b5s a step");
  fifty.run.playing = true;
  EXPECT_EQ(fifty.row("Pace"), "250 \u00b5s a step, 0.50 x real time");
}

TEST(SceneInfo, NamesIslandsAndEnergyIfThereAreAny) {
  StepFifty fifty;
  fifty.frame->facts.contacts = 3, fifty.frame->facts.constraints = 1;
  EXPECT_EQ(fifty.row("Contacts"), "3 of MuJoCo, 1 constraint");
  fifty.frame->facts.islands = 2;
  EXPECT_EQ(fifty.row("Contacts"), "3 of MuJoCo, 1 constraint in 2 islands");
  EXPECT_EQ(fifty.row("Energy"), "off: <flag energy=\"enable\"/>");
  fifty.frame->facts.energy = SceneEnergy{1.5, 0.25};
  EXPECT_EQ(fifty.row("Energy"), "potential 1.5 J, kinetic 0.25 J");
}

TEST(SceneInfo, GivesTheUsedPartOfTheMemory) {
  StepFifty fifty;
  fifty.frame->facts.arena = 500;
  EXPECT_EQ(fifty.row("Memory"), "500 bytes of 2 kB, 25.0 %");
}

TEST(SceneInfo, OmitsTheSolverOfASavedStep) {
  StepFifty fifty;
  fifty.frame->mark_poses.bodies.clear();
  EXPECT_EQ(fifty.row("Size"), "1 geom");
  EXPECT_EQ(fifty.row("Solver"), "");
}

TEST(SceneInfo, CountsPolygonsAndHits) {
  StepFifty fifty;
  EXPECT_EQ(fifty.row("Sensors"), "") << "the scene has no sensor";
  fifty.frame->sensors.resize(1);
  fifty.frame->sensors[0].surfaces.resize(1);
  fifty.frame->sensors[0].surfaces[0].polygons.resize(3);
  fifty.frame->sensors[0].hits.resize(2);
  EXPECT_EQ(fifty.row("Sensors"), "1: 3 polygons, 0 of 2 rays hit");
}

}  // namespace
}  // namespace taxel::ui
