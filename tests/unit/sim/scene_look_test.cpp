// Materials, textures, lights and sky of a user's file; and the geoms that a skin covers.
#include "core/sim/model/scene_look.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/sim/simulator.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

std::shared_ptr<const SimScene> load_lit(const test::SensorScene& s, const std::string& xml,
                                         const std::vector<SceneAttachment>& attachments = {}) {
  write_file_atomically(s.folder / "scene.xml", xml);
  return Simulator::load(s.folder / "scene.xml", attachments)->scene();
}

constexpr const char* kLitScene = R"(<mujoco><statistic center='1 2 3' extent='4'/><visual>
  <headlight ambient='.2 .1 0' diffuse='.3 .3 .3' specular='.1 .1 .1'/><rgba haze='.1 .2 .3 1'/></visual>
  <asset><texture type='skybox' builtin='gradient' rgb1='1 0 0' rgb2='0 0 1' width='8' height='48'/>
  <texture name='check' type='2d' builtin='checker' rgb1='0 0 0' rgb2='1 1 1' width='16' height='8'/>
  <material name='floor' texture='check' texrepeat='3 5' texuniform='true' reflectance='.25'/>
  <material name='black' rgba='.1 .1 .1 1' specular='.7' shininess='.4' emission='.05'/></asset><worldbody>
  <light pos='0 0 3' diffuse='.1 .2 .3' cutoff='30' exponent='4'/>
  <light type='directional' dir='0 1 -1' castshadow='false'/><light active='false' pos='9 9 9'/>
  <geom type='plane' size='0 2 1' material='floor'/><body pos='0 0 1'><geom size='.1' material='black'/>
  <geom size='.2' rgba='1 0 0 1'/></body></worldbody></mujoco>)";

TEST(SceneLook, HasTheValuesOfTheFile) {
  const test::SensorScene s;
  const auto scene = load_lit(s, kLitScene);
  ASSERT_NE(scene->look, nullptr);
  const SceneLook& look = *scene->look;
  ASSERT_EQ(look.lights.size(), 2U) << "a light that is off lights nothing";
  EXPECT_EQ(look.lights[0].kind, LightKind::spot);
  EXPECT_EQ(look.lights[0].p_B, dvec3(0, 0, 3));
  EXPECT_EQ(look.lights[0].diffuse, glm::vec3(.1f, .2f, .3f));
  EXPECT_EQ(look.lights[0].cutoff_deg, 30);
  EXPECT_EQ(look.lights[0].exponent, 4);
  EXPECT_EQ(look.lights[1].kind, LightKind::directional);
  EXPECT_FALSE(look.lights[1].casts_shadow);
  EXPECT_NEAR(look.lights[1].direction_B.y, std::sqrt(0.5), 1e-12);
  ASSERT_TRUE(look.headlight);
  EXPECT_EQ(look.headlight->ambient, glm::vec3(.2f, .1f, 0));
  EXPECT_EQ(look.haze, glm::vec3(.1f, .2f, .3f));
  EXPECT_TRUE(look.has_own_view);
  ASSERT_NE(look.sky, nullptr);
  EXPECT_TRUE(look.sky->cube);
  EXPECT_EQ(look.sky->height, 48);
}

TEST(SceneLook, TakesTheColorOfAGeomBeforeThatOfItsMaterial) {
  const test::SensorScene s;
  const auto scene = load_lit(s, R"(<mujoco><asset><material name='red' rgba='1 0 0 1'/></asset><worldbody>
    <geom size='.1' material='red'/><geom size='.1' material='red' rgba='0 0 1 .5'/>
    <site name='a' material='red'/><site name='b' material='red' rgba='0 1 0 1'/></worldbody></mujoco>)");
  ASSERT_EQ(scene->geoms.size(), 2U);
  EXPECT_EQ(scene->geoms[0].rgba, (std::array<float, 4>{1, 0, 0, 1}));
  EXPECT_EQ(scene->geoms[1].rgba, (std::array<float, 4>{0, 0, 1, 0.5f}));
  ASSERT_EQ(scene->marks.sites.size(), 2U);
  EXPECT_EQ(scene->marks.sites[0].rgba, (std::array<float, 4>{1, 0, 0, 1}));
  EXPECT_EQ(scene->marks.sites[1].rgba, (std::array<float, 4>{0, 1, 0, 1}));
}

TEST(SceneLook, GivesEachGeomItsMaterial) {
  const test::SensorScene s;
  const auto scene = load_lit(s, kLitScene);
  ASSERT_EQ(scene->geoms.size(), 3U);
  const SceneMaterialPtr& floor = scene->geoms[0].material;
  ASSERT_NE(floor, nullptr);
  EXPECT_EQ(floor->repeat, glm::vec2(3, 5));
  EXPECT_TRUE(floor->uniform);
  EXPECT_EQ(floor->reflectance, .25f);
  EXPECT_EQ(scene->geoms[0].plane_size[0], 0) << "infinite";
  EXPECT_EQ(scene->geoms[0].plane_size[1], 2);
  ASSERT_NE(floor->texture, nullptr);
  EXPECT_EQ(floor->texture->pixels.size(), 16U * 8 * static_cast<std::size_t>(floor->texture->channels));
  ASSERT_NE(scene->geoms[1].material, nullptr);
  EXPECT_EQ(scene->geoms[1].material->specular, .7f);
  EXPECT_EQ(scene->geoms[1].material->shininess, .4f);
  EXPECT_EQ(scene->geoms[1].material->emission, .05f);
  EXPECT_EQ(scene->geoms[2].material, nullptr) << "MuJoCo's default";
}

TEST(SceneLook, KnowsAFileWithoutAViewOfItsOwn) {
  const test::SensorScene s;
  const auto scene = load_lit(s, "<mujoco><worldbody><geom size='.1'/></worldbody></mujoco>");
  EXPECT_FALSE(scene->look->has_own_view);
  EXPECT_EQ(scene->look->sky, nullptr);
  EXPECT_TRUE(scene->look->lights.empty());
}

/// Returns a finger whose collision mesh `skin` gets a layout. `visual` is the geom that is drawn, `scale` the factor
/// of its mesh.
std::string finger_with(const std::string& visual, double scale = 1) {
  const std::string mesh = TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj";
  return fmt::format(
      R"(<mujoco><asset><mesh name='m' file='{0}'/><mesh name='v' file='{0}' scale='{1} {1} {1}'/></asset>
    <worldbody><body name='tip' pos='1 2 3' euler='10 20 30'><geom name='skin' type='mesh' mesh='m' group='3'/>{2}</body>
    <body pos='1 2 3' euler='10 20 30'><freejoint/><geom name='apart' type='mesh' mesh='m' mass='1'/></body>
    </worldbody></mujoco>)",
      mesh, scale, visual);
}
const std::vector<SceneAttachment> kOnSkin{{"skin", TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json"}};

int covered_by(const SimScene& scene, const std::string& name) {
  for (const SceneGeom& geom : scene.geoms)
    if (geom.name == name) return geom.covered_by;
  ADD_FAILURE() << "no geom " << name;
  return -2;
}

TEST(CoveredGeoms, AreThoseThatCoincideWithASkin) {
  const test::SensorScene s;
  const auto scene =
      load_lit(s, finger_with("<geom name='visual' type='mesh' mesh='v' contype='0' conaffinity='0'/>"), kOnSkin);
  EXPECT_EQ(covered_by(*scene, "visual"), 0);
  EXPECT_EQ(covered_by(*scene, "skin"), -1) << "the skin is drawn";
  EXPECT_EQ(covered_by(*scene, "apart"), -1) << "it can move away";
}

TEST(CoveredGeoms, AreMeasuredNotNamed) {
  const test::SensorScene s;
  const std::string visual = "<geom name='visual' type='mesh' mesh='v' contype='0' conaffinity='0'";
  EXPECT_EQ(covered_by(*load_lit(s, finger_with(visual + "/>", 1.01), kOnSkin), "visual"), 0) << "0.1 mm larger";
  EXPECT_EQ(covered_by(*load_lit(s, finger_with(visual + "/>", 1.2), kOnSkin), "visual"), -1) << "a larger shell";
  EXPECT_EQ(covered_by(*load_lit(s, finger_with(visual + " pos='.002 0 0'/>"), kOnSkin), "visual"), -1) << "2 mm aside";
  EXPECT_EQ(covered_by(*load_lit(s, finger_with("<geom name='visual' size='.004' contype='0'/>"), kOnSkin), "visual"),
            -1)
      << "inside of the finger";
}

}  // namespace
}  // namespace taxel
