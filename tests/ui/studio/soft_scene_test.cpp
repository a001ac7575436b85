// Scenes with soft geoms without taxels in the window: surfaces and forces are displayed, and a layout can be attached
// later.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// A soft ball between a rigid floor and a soft box.
constexpr const char* kScene = R"(<mujoco><option gravity='0 0 0'/><extension><plugin plugin='taxel.contact'>
  <instance name='soft'><config key='materials' value='{"ball": {"modulus": 1e5}, "box": {"modulus": 2e5}}'/>
  <config key='pairs' value='ball floor, ball box'/></instance></plugin></extension><worldbody>
  <geom name='floor' type='plane' size='.3 .3 .1'/>
  <body name='ball' pos='0 0 .045'><geom name='ball' type='sphere' size='.05' rgba='.9 .7 .3 .4'/></body>
  <body name='box' pos='0 0 .128'><geom name='box' type='box' size='.04 .04 .04' rgba='.5 .7 .9 .4'/></body>
  </worldbody></mujoco>)";

TEST(SoftScene, ShowsSurfacesAndForcesWithoutTaxels) {
  const StudioProgram studio;
  write_text(studio.folder() / "scene.xml", kScene);
  studio.play({kIdle, key("Space"), kIdle, dump("open.json"), R"({"do": "screenshot", "file": "with.png"})", key("C"),
               kIdle, dump("toggled.json"), R"({"do": "screenshot", "file": "without.png"})", key("C"), kIdle,
               kLayoutMode, kIdle, key("2", kCtrl), kIdle, dump("stepped.json")},
              {"scene.xml"});
  const Json open = studio.state("open.json");
  ASSERT_EQ(open["simulation"]["sensors"].size(), 2U);
  for (const Json& soft : open["simulation"]["sensors"]) {
    EXPECT_TRUE(soft["readings"].empty());
    EXPECT_GT(soft["polygons"].get<int>(), 10);
    EXPECT_GT(soft["max_pressure"].get<double>(), 100);
  }
  const double on_ball = open["simulation"]["sensors"][0]["force"][2],
               on_box = open["simulation"]["sensors"][1]["force"][2];
  EXPECT_GT(on_box, 0.1);
  EXPECT_LT(on_ball, -0.1);  // the ball is pressed deeper by the box than by the floor
  EXPECT_EQ(studio.state("toggled.json")["overlays"]["contact_surface"], false);
  EXPECT_TRUE(open["bars"].empty());
  EXPECT_EQ(studio.state("stepped.json")["simulation"]["sensors"][0]["polygons"],
            open["simulation"]["sensors"][0]["polygons"]);
  EXPECT_NE(studio.picture("with.png").rgb, studio.picture("without.png").rgb);
}

}  // namespace
}  // namespace taxel::test
