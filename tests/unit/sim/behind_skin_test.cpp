// Bodies that are behind a skin, deeper than its pad, are reported once.
#include "core/hydro/hydro_body.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "fixtures/hydro_bodies.h"
#include "fixtures/pad_meshes.h"
#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

/// Returns a scene of a soft block, whose top is at z = 0, and a free body at the height `z` of its middle.
std::string block_and(const std::string& geom, double z, double modulus) {
  return fmt::format(
      "<mujoco><option timestep='0.001'/><extension><plugin plugin='taxel.contact'><instance name='soft'>{}{}"
      "</instance></plugin></extension><worldbody>"
      "<geom name='block' type='box' size='.03 .03 .02' pos='0 0 -.02' contype='0' conaffinity='0'/>"
      "<body pos='0 0 {}'><freejoint/><geom name='thing' contype='0' conaffinity='0' {}/></body></worldbody></mujoco>",
      key("materials", fmt::format("{{\"block\": {{\"modulus\": {}, \"thickness\": 0.002, \"field\": \"pad\", "
                                   "\"dissipation\": 5, \"friction\": 0.5}}}}",
                                   modulus)),
      key("pairs", "block thing"), z, geom);
}

constexpr const char* kCard = "type='box' size='.01 .01 .0001' mass='.01'";

std::vector<std::string> warnings_after(const std::string& xml, int steps) {
  SensorScene s;
  s.compile(xml);
  EXPECT_NE(s.model, nullptr) << s.error;
  if (s.model == nullptr) return {};
  s.step(steps);
  return find_body(*s.data, {0, 0})->warnings;
}

TEST(BehindSkin, IsReportedOnceWithNamesAndDepth) {
  const std::vector<std::string> warnings = warnings_after(block_and(kCard, -0.005, 1e3), 100);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(
      warnings[0].find("at 0 s the middle of geom \"thing\" is 5 mm behind the skin of geom \"block\", whose pad is "
                       "2 mm thick: move it out"),
      std::string::npos)
      << warnings[0];
}

TEST(BehindSkin, IsReportedOfABodyThatFallsThrough) {
  const std::vector<std::string> warnings =
      warnings_after(block_and("type='box' size='.01 .01 .0001' mass='5'", 0.0002, 1e3), 400);
  const auto through = [](const std::string& text) { return text.find("if it fell through") != std::string::npos; };
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), through), 1);
}

TEST(BehindSkin, IsNotReportedOfBodiesThatRestOnThePad) {
  for (const char* geom : {kCard, "type='sphere' size='.005' mass='.02'"})
    EXPECT_EQ(warnings_after(block_and(geom, 0.0049, 5e4), 1000), std::vector<std::string>{}) << geom;
}

/// With k = E/H A the lower face rests m g/k below the skin, whatever the thickness of the plate.
TEST(FreePlate, RestsWhereAThickOneDoes) {
  constexpr double modulus = 2e3, stiffness = modulus / 0.002 * 4e-4;  // [Pa], [N/m]
  for (const double weight : {0.1, 0.25, 0.5}) {
    for (const double thickness : {0.0002, 0.006}) {
      SensorScene s;
      s.compile(block_and(fmt::format("type='box' size='.01 .01 {}' mass='{}'", 0.5 * thickness, weight / 9.81),
                          0.5 * thickness, modulus));
      ASSERT_NE(s.model, nullptr) << s.error;
      s.step(3000);
      const double depth = 0.5 * thickness - s.data->qpos[2];
      EXPECT_NEAR(depth, weight / stiffness, 0.01 * weight / stiffness) << thickness << " m thick, " << weight << " N";
    }
  }
}

TEST(BehindSkin, IsMeasuredInTheMaterialOfHollowBodies) {
  const auto ring = make_mesh_body(make_torus(0.010, 0.001, 64, 16));
  EXPECT_NEAR(glm::length(inner_point(*ring)), 0.009, 1e-4) << "the finger inside of a ring is not behind it";
  const auto box = make_simple_body(ShapeType::box, dvec3(0.01, 0.02, 0.03));
  EXPECT_EQ(inner_point(*box), dvec3(0));
}

TEST(BehindSkin, IsTheDistanceToTheSkin) {
  const auto pad = make_mesh_body(make_box(dvec3(0.01)), soft_material(5e4, 0.002));
  EXPECT_NEAR(behind_skin(*pad, dvec3(0.001, 0, 0.004)).depth, 0.006, 1e-12);
  EXPECT_NEAR(behind_skin(*pad, dvec3(0, 0, 0.013)).depth, -0.003, 1e-12);
  EXPECT_EQ(behind_skin(*pad, dvec3(0)).thickness, 0.002);
  const auto floor = make_simple_body(ShapeType::plane, dvec3(0), soft_material(5e4, 0.005));
  EXPECT_TRUE(behind_skin(*floor, dvec3(0, 0, -0.006)).beyond_the_pad());
  EXPECT_FALSE(behind_skin(*floor, dvec3(0, 0, -0.004)).beyond_the_pad());
}

}  // namespace
}  // namespace taxel::test
