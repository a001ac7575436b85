// The filters of lists about the scene.
#include "app/studio/frame/scene_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/sim/simulator.h"

namespace taxel::ui {
namespace {

/// A hand of two bodies, each with a drawn and a colliding geom, and a floor.
SimScene named_hand() {
  SimScene scene;
  for (const char* name : {"world", "rh_ffdistal", "rh_thdistal"}) scene.controls.bodies.push_back({name});
  const auto add = [&](const char* label, const char* name, const char* class_name, const char* mesh, int body) {
    SceneGeom& geom = scene.geoms.emplace_back();
    geom.label = label;
    geom.name = name;
    geom.class_name = class_name;
    geom.mesh_name = mesh;
    geom.body_index = body;
    geom.body = scene.controls.bodies[static_cast<std::size_t>(body)].name;
  };
  add("floor", "floor", "", "", 0);
  add("rh_ffdistal, plastic_visual", "rh_ffdistal", "plastic_visual", "f_distal_pst", 1);
  add("rh_ffdistal, plastic_collision", "rh_ffdistal_2", "plastic_collision", "f_distal_pst", 1);
  add("rh_thdistal, plastic_visual", "rh_thdistal", "plastic_visual", "th_distal_pst", 2);
  scene.geoms[3].sensor = 0;
  scene.sensor_geoms = {"rh_thdistal"};
  scene.marks.joints = {{"rh_FFJ1", 1, dvec3(0)}, {"rh_THJ1", 2, dvec3(0)}};
  SceneSite site;
  site.name = "rh_tip_of_thumb";
  site.body = 2;
  scene.marks.sites = {site};
  scene.controls.actuators = {{"rh_A_THJ1", {}, "rh_THJ1"}, {"rh_A_FFJ0", {}, ""}};
  return scene;
}

std::vector<std::string> found(const std::string& filter) {
  const SimScene scene = named_hand();
  std::vector<std::string> names;
  for (const SceneGeom& geom : scene.geoms)
    if (finds_geom(filter, scene, geom)) names.push_back(geom.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(SceneFilter, FindsGeomsByBodyMeshClassJointAndSite) {
  EXPECT_EQ(found("").size(), 4U);
  EXPECT_EQ(found("FFDistal"), (Names{"rh_ffdistal", "rh_ffdistal_2"}));
  EXPECT_EQ(found("th_distal_pst"), Names{"rh_thdistal"});
  EXPECT_EQ(found("collision"), Names{"rh_ffdistal_2"});
  EXPECT_EQ(found("THJ1"), Names{"rh_thdistal"});
  EXPECT_EQ(found("tip_of"), Names{"rh_thdistal"});
  EXPECT_EQ(found("world"), Names{"floor"});
  EXPECT_EQ(found("fftip"), Names{});
}

TEST(SceneFilter, WantsEachWordInOneOfTheNames) {
  EXPECT_EQ(found("visual ffj"), Names{"rh_ffdistal"});
  EXPECT_EQ(found("  distal   visual "), (Names{"rh_ffdistal", "rh_thdistal"}));
  EXPECT_EQ(found("rh_ffdistal, plastic_collision"), Names{"rh_ffdistal_2"}) << "a whole label";
  EXPECT_EQ(found("visual ffj thumb"), Names{});
}

TEST(SceneFilter, FindsJointsActuatorsAndSensorsByTheirBodies) {
  const SimScene scene = named_hand();
  EXPECT_TRUE(finds_joint("thdistal", scene, "rh_THJ1"));
  EXPECT_TRUE(finds_joint("thj1", scene, "rh_THJ1"));
  EXPECT_FALSE(finds_joint("thdistal", scene, "rh_FFJ1"));
  EXPECT_TRUE(finds_actuator("rh_thdistal", scene, scene.controls.actuators[0]));
  EXPECT_FALSE(finds_actuator("rh_thdistal", scene, scene.controls.actuators[1])) << "it drives a tendon";
  EXPECT_TRUE(finds_actuator("a_ffj0", scene, scene.controls.actuators[1]));
  EXPECT_TRUE(finds_sensor("thj1 visual", scene, 0));
  EXPECT_FALSE(finds_sensor("ffj1", scene, 0));
  EXPECT_EQ(body_of_sensor(scene, 0), 2);
  EXPECT_EQ(body_of_sensor(scene, 1), -1);
}

/// Returns the number of geoms of a scene that a filter finds.
int count_found(const SimScene& scene, const std::string& filter) {
  return static_cast<int>(
      std::ranges::count_if(scene.geoms, [&](const SceneGeom& geom) { return finds_geom(filter, scene, geom); }));
}

TEST(SceneFilter, FindsAllNamesOfRealHands) {
  for (const char* file : {"shadow_hand/scene_right.xml", "wonik_allegro/scene_left.xml"}) {
    const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / "hands" / file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
    const auto scene = Simulator::load(path)->scene();
    std::set<std::string> labels, names;
    for (const SceneGeom& geom : scene->geoms) {
      labels.insert(geom.shown_name());
      names.insert(geom.name);
      EXPECT_EQ(geom.shown_name().find("geom "), std::string::npos) << geom.label;
      EXPECT_GT(count_found(*scene, geom.body), 0) << geom.body;
      EXPECT_GT(count_found(*scene, geom.class_name + " " + geom.mesh_name), 0) << geom.label;
      EXPECT_GT(count_found(*scene, geom.shown_name()), 0) << geom.label;
    }
    EXPECT_EQ(labels.size(), scene->geoms.size());
    EXPECT_EQ(names.size(), scene->geoms.size());
    for (const SceneJointPlace& joint : scene->marks.joints) {
      EXPECT_GT(count_found(*scene, joint.name), 0) << joint.name;
      EXPECT_TRUE(finds_joint(joint.name, *scene, joint.name));
    }
  }
}

}  // namespace
}  // namespace taxel::ui
