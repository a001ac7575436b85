// Names of geoms in scenes of hands whose geoms have no names, from the file to sensors, notes and saved scenes.
#include "core/sim/scene/scene_names.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/run/recording/run_recorder.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::complaint_of;
using test::SensorScene;
using Texts = std::vector<std::string>;

/// A hand as the Shadow hand is written: classes for the drawn and the colliding geoms, several geoms in a body.
constexpr const char* kClassHand = R"(<mujoco><default><default class='right_hand'>
  <default class='plastic_visual'><geom type='mesh' contype='0' conaffinity='0' group='2'/></default>
  <default class='plastic_collision'><geom group='3'/></default></default></default>
  <asset><mesh name='ball' file='ball.obj'/><mesh name='palm' file='ball.obj'/></asset><worldbody>
  <geom name='floor' type='plane' size='1 1 1' pos='0 0 -1'/>
  <body name='rh_palm' childclass='right_hand'>
    <geom class='plastic_visual' mesh='palm'/><geom class='plastic_visual' mesh='ball'/>
    <geom class='plastic_collision' type='box' size='.01 .01 .01'/>
    <geom class='plastic_collision' type='box' size='.01 .01 .02'/><geom size='.01'/>
    <body name='rh_ffdistal' pos='.1 0 0'><joint name='rh_FFJ1'/>
      <geom class='plastic_visual' mesh='ball'/><geom class='plastic_collision' type='mesh' mesh='ball'/></body>
    <body name='rh_thdistal' pos='.2 0 0'><joint name='rh_THJ1'/>
      <geom class='plastic_visual' mesh='ball'/><geom class='plastic_collision' size='.0199'/></body></body>
  <body pos='.4 0 0'><freejoint/><geom type='ellipsoid' size='.01 .02 .03'/></body></worldbody></mujoco>)";

/// A hand as the Allegro hand is written: nested classes that hold mesh and shape, and short names of bodies.
constexpr const char* kNestedClasses = R"(<mujoco><default><default class='visual'><geom type='mesh' contype='0'
  conaffinity='0'/><default class='tip_visual'><geom mesh='ball'/></default></default>
  <default class='collision'><geom/><default class='tip_collision'><geom type='capsule' size='.012 .01'/></default>
  </default></default><asset><mesh name='ball' file='ball.obj'/></asset><worldbody><body name='palm'>
  <body name='ff_tip'><joint name='ffj3'/><geom class='tip_visual'/><geom class='tip_collision'/></body>
  <body name='th_tip' pos='.035 0 0'><joint name='thj3'/><geom class='tip_visual'/><geom class='tip_collision'/></body>
  </body></worldbody></mujoco>)";

class SceneNamesTest : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }
  std::filesystem::path write(const std::string& xml) {
    write_file_atomically(s.folder / "scene.xml", xml);
    return s.folder / "scene.xml";
  }
  std::string layout() const { return (s.folder / "ball.taxels.json").string(); }
  SensorScene s;
};

Texts names_of(const mjModel& m) {
  Texts names;
  for (int g = 0; g < m.ngeom; ++g) names.emplace_back(m.names + m.name_geomadr[g]);
  return names;
}

TEST_F(SceneNamesTest, CallGeomsByBodyAndClass) {
  const CompiledScene scene = load_scene(write(kClassHand), {});
  const Texts expected = {"floor",
                          "rh_palm, plastic_visual, palm",
                          "rh_palm, plastic_visual, ball",
                          "rh_palm, plastic_collision, box 1",
                          "rh_palm, plastic_collision, box 2",
                          "rh_palm, sphere",
                          "rh_ffdistal, plastic_visual",
                          "rh_ffdistal, plastic_collision",
                          "rh_thdistal, plastic_visual",
                          "rh_thdistal, plastic_collision",
                          "body 4, ellipsoid"};
  EXPECT_EQ(names_of(*scene.model), expected);
  EXPECT_EQ(names_of(*load_scene(write(kNestedClasses), {}).model),
            (Texts{"ff_tip, tip_visual", "ff_tip, tip_collision", "th_tip, tip_visual", "th_tip, tip_collision"}));
}

TEST_F(SceneNamesTest, FindGeomsByNameLabelAndFormerNumber) {
  const SceneNames names = load_scene(write(kClassHand), {}).names;
  EXPECT_EQ(names.find("floor"), 0);
  EXPECT_EQ(names.find("rh_ffdistal, plastic_collision"), 7);
  EXPECT_EQ(names.find("rh_ffdistal, ball 2"), 7) << "as the plugin calls it in a model without classes";
  EXPECT_EQ(names.find("geom 7"), 7);
  EXPECT_EQ(names.find("rh_ffdistal"), 6) << "the name that it has with a sensor";
  EXPECT_EQ(names.find("rh_ffdistal_2"), 7);
  for (const char* text : {"", "geom 11", "geom", "rh_palm", "ffdistal, plastic_visual"})
    EXPECT_EQ(names.find(text), -1) << text;
  EXPECT_EQ(names.mesh_geom_of_body("rh_ffdistal", "f"), 6);
  EXPECT_EQ(complaint_of([&] { (void)names.mesh_geom_of_body("rh_palm", "f"); }),
            "f: body \"rh_palm\" has the meshes of \"rh_palm, plastic_visual, palm\" (palm) and \"rh_palm, "
            "plastic_visual, ball\" (ball): choose one with --geom");
}

TEST_F(SceneNamesTest, NameSensorsAfterTheirBodies) {
  const auto simulator = Simulator::load(write(kClassHand), {{"rh_ffdistal, plastic_visual", layout()},
                                                             {"", layout(), {}, "rh_thdistal"},
                                                             {"geom 2", layout()},
                                                             {"rh_palm, plastic_visual, palm", layout()}});
  const SimScene& scene = *simulator->scene();
  EXPECT_EQ(scene.sensor_geoms, (Texts{"rh_ffdistal", "rh_thdistal", "rh_palm_ball", "rh_palm_palm"}));
  const auto geom = std::ranges::find(scene.geoms, "rh_ffdistal, plastic_collision", &SceneGeom::label);
  ASSERT_NE(geom, scene.geoms.end());
  EXPECT_EQ(geom->name, "rh_ffdistal_2");
  EXPECT_EQ(geom->class_name, "plastic_collision");
  EXPECT_EQ(geom->mesh_name, "ball");
  EXPECT_EQ(geom->body, "rh_ffdistal");
}

TEST_F(SceneNamesTest, AppearInNotesAndErrors) {
  const CompiledScene scene = load_scene(write(kClassHand), {{"rh_ffdistal, plastic_visual", layout()}});
  EXPECT_EQ(scene.notes, Texts{"the skin on \"rh_ffdistal\" replaces the contacts of what lies within it: "
                               "\"rh_ffdistal, plastic_collision\" (100 % of its surface)"});
  const auto refusal = [&](const std::string& geom) {
    return complaint_of([&] { load_scene(s.folder / "scene.xml", {{geom, layout()}}); });
  };
  EXPECT_NE(refusal("rh_palm").find(": no geom is named \"rh_palm\", but a body: its geoms are \"rh_palm, "
                                    "plastic_visual, palm\", \"rh_palm, plastic_visual, ball\", "),
            std::string::npos)
      << refusal("rh_palm");
  EXPECT_NE(refusal("geom 99").find("no geom named \"geom 99\""), std::string::npos);
}

TEST_F(SceneNamesTest, AppearInOneNoteOfAllSkinsThatReplaceContacts) {
  const CompiledScene scene = load_scene(
      write(kClassHand), {{"rh_ffdistal, plastic_visual", layout()}, {"rh_thdistal, plastic_visual", layout()}});
  EXPECT_EQ(scene.notes, Texts{"2 skins replace the contacts of what lies within them: "
                               "\"rh_ffdistal, plastic_collision\" (100 % of its surface), "
                               "\"rh_thdistal, plastic_collision\" (100 % of its surface)"});
}

/// Two skins touch one box, of whose mesh a triangle faces inwards.
TEST_F(SceneNamesTest, AppearInOneNoteOfARepairedGeomThatSeveralSkinsTouch) {
  write_file_atomically(s.folder / "box.obj",
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                        "f 1 2 3\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\n"
                        "f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n");
  const auto simulator = Simulator::load(
      write(
          "<mujoco><asset><mesh name='ball' file='ball.obj'/><mesh name='box' file='box.obj' inertia='shell'/></asset>"
          "<worldbody><geom name='box' type='mesh' mesh='box' pos='9 0 0'/>"
          "<body><freejoint/><geom name='a' type='mesh' mesh='ball'/></body>"
          "<body pos='1 0 0'><freejoint/><geom name='b' type='mesh' mesh='ball'/></body></worldbody></mujoco>"),
      {{"a", layout()}, {"b", layout()}});
  EXPECT_EQ(simulator->repairs(),
            Texts{"sensor \"taxels of a\" and 1 more: geom \"box\": repaired: 1 face turned outward, no vertex moved"});
}

TEST_F(SceneNamesTest, LeaveSavedScenesWithoutLabels) {
  const auto simulator = Simulator::load(write(kClassHand), {{"rh_ffdistal, plastic_visual", layout()}});
  const std::string xml = simulator->files().xml;
  EXPECT_EQ(xml.find("plastic_visual\" type"), std::string::npos);
  EXPECT_EQ(xml.find("name=\"rh_thdistal, "), std::string::npos);
  EXPECT_NE(xml.find("<geom name=\"rh_ffdistal\" class=\"plastic_visual\""), std::string::npos) << xml;
  write_scene(s.folder / "saved" / "scene.xml", simulator->files());
  const auto again = Simulator::load(s.folder / "saved" / "scene.xml");
  const auto names = [](const Simulator& one) {
    Texts texts;
    for (const SceneGeom& geom : one.scene()->geoms) texts.push_back(geom.name);
    return texts;
  };
  EXPECT_EQ(names(*again), names(*simulator));
}

TEST_F(SceneNamesTest, KeepTheReadings) {
  // The same scene whose geoms have names gives the same step, bit for bit.
  std::string named = kNestedClasses;
  for (const char* body : {"ff", "th"}) {
    const std::string place = std::string("<joint name='") + body + "j3'/><geom ";
    named.replace(named.find(place), place.size(), place + "name='" + body + "_skin' ");
  }
  const auto forces = [&](const std::string& xml, const char* first, const char* second) {
    const auto simulator = Simulator::load(write(xml), {{first, layout()}, {second, layout()}});
    for (int i = 0; i < 20; ++i) simulator->step();
    const RecordedRow row = row_of(simulator->view());
    return std::vector{row.sensors[0].force_W, row.sensors[1].force_W};
  };
  const std::vector<dvec3> unnamed = forces(kNestedClasses, "ff_tip, tip_visual", "th_tip, tip_visual");
  EXPECT_EQ(unnamed, forces(named, "ff_skin", "th_skin"));
  EXPECT_GT(glm::length(unnamed[0]), 0.01);
}

}  // namespace
}  // namespace taxel
