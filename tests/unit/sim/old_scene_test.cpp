// Scenes of the predecessor's code, whose custom fields name the soft bodies, and layouts on geoms of any scene.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

/// Returns a scene with a box of 2 kg on a soft box, 25 mm high, as in the predecessor's scenes.
std::string old_scene(const std::string& more_fields) {
  return "<mujoco><option timestep='0.001'/><custom><text name='cs::HydroelasticContactRepresentation' "
         "data='kTriangle'/>"
         "<numeric name='cs::VisualizeSurfaces' data='1'/><numeric name='cs::thing' data='0 1.0 0.05 0.3 0.2'/>"
         "<numeric name='cs::foam' data='5e4 5.0 0 0.3 0.3'/>" +
         more_fields +
         "</custom><worldbody><geom name='ground' type='plane' size='0 0 1'/><body pos='0 0 0.0505'><freejoint/>"
         "<geom name='thing' type='box' size='.02 .02 .02' mass='2'/></body><body><geom name='foam' type='box' "
         "pos='0 0 .02' size='.05 .05 .0125'/></body></worldbody></mujoco>";
}

class OldScene : public testing::Test {
 protected:
  std::unique_ptr<Simulator> load(const std::string& xml, const std::vector<SceneAttachment>& attachments = {}) {
    write_file_atomically(s.folder / "scene.xml", xml);
    return Simulator::load(s.folder / "scene.xml", attachments);
  }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
  test::SensorScene s;
};

TEST_F(OldScene, CarriesTheWeightOfABodyOnASoftBox) {
  const auto simulator = load(old_scene("<numeric name='cs::ApplyContactSurfaceForces' data='1'/>"));
  ASSERT_EQ(simulator->scene()->sensors.size(), 1U);
  EXPECT_EQ(simulator->scene()->sensor_geoms[0], "foam");
  EXPECT_EQ(simulator->scene()->sensors[0]->taxel_count(), 16);  // one for each 25 mm
  const Material& material = simulator->scene()->sensors[0]->layout.material;
  EXPECT_EQ(material.modulus, 5e4);
  EXPECT_EQ(material.dissipation, 5);
  EXPECT_EQ(material.friction, 0.3);
  EXPECT_EQ(material.thickness, 0.0125);
  for (int n = 0; n < 1000; ++n) simulator->step();
  EXPECT_NEAR(row_of(simulator->view()).sensors[0].force_W.z, -2 * 9.81, 0.02 * 2 * 9.81);
  // p = F/A under the middle four taxels, which the box covers.
  EXPECT_NEAR(row_of(simulator->view()).sensors[0].readings[5], 2 * 9.81 / (0.04 * 0.04),
              0.25 * 2 * 9.81 / (0.04 * 0.04));
  EXPECT_EQ(row_of(simulator->view()).sensors[0].readings[0], 0);
  EXPECT_TRUE(simulator->warnings().empty()) << simulator->warnings()[0];  // the box is the layout's
}

TEST_F(OldScene, SensesSurfacesWhoseForcesAreNotApplied) {
  const auto simulator = load(old_scene("<numeric name='cs::ApplyContactSurfaceForces' data='0'/>"));
  for (int n = 0; n < 500; ++n) simulator->step();
  // MuJoCo's own contact carries the box on the surface: 2 kg compress the stiff contact less than the foam.
  const double depth = 0.0525 - simulator->view().geom_poses.at(1).p.z;
  EXPECT_LT(depth, 2 * 9.81 / (5e4 / 0.0125 * 0.0016) * 0.9);
}

TEST_F(OldScene, ReportsASoftMeshThatNothingCanTouch) {
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  const auto simulator = load(
      "<mujoco><custom><numeric name='cs::ball' data='5e4 5.0 0 0.3 0.3'/><numeric name='cs::gone' data='5e4'/>"
      "</custom><asset><mesh name='ball' file='ball.obj'/></asset><worldbody><geom name='ball' type='mesh' "
      "mesh='ball'/></worldbody></mujoco>");
  EXPECT_TRUE(simulator->scene()->sensors.empty());
  ASSERT_EQ(simulator->warnings().size(), 1U);
  EXPECT_TRUE(has(simulator->warnings()[0], "geom \"ball\" is soft")) << simulator->warnings()[0];
}

/// A soft mesh and a soft sphere on a rigid plane that its field declares soft.
TEST_F(OldScene, HasContactOfSoftMeshesWithoutTaxels) {
  s.add_sensor("ball", make_sphere(0.02, 0.004), {FieldKind::star, 5e4, 0, 5, 0.5});
  const auto simulator = load(
      "<mujoco><option timestep='0.001'/><custom><numeric name='cs::ball' data='2e5 20.0 0 0.3 0.3'/>"
      "<numeric name='cs::round' data='2e5 20 0 0.3 0.3'/><numeric name='cs::floor' data='5e4 1 0 0.3 0.3'/></custom>"
      "<asset><mesh name='ball' file='ball.obj'/></asset><worldbody><geom name='floor' type='plane' size='1 1 1'/>"
      "<body pos='0 0 0.02'><freejoint/><geom name='ball' type='mesh' mesh='ball' mass='.1'/></body>"
      "<body pos='.1 0 0.02'><freejoint/><geom name='round' type='sphere' size='.02' mass='.1'/></body>"
      "</worldbody></mujoco>");
  EXPECT_EQ(simulator->scene()->sensor_geoms, (std::vector<std::string>{"ball", "round"}));
  ASSERT_EQ(simulator->warnings().size(), 1U);
  EXPECT_TRUE(has(simulator->warnings()[0], "\"cs::floor\" makes geom \"floor\" soft")) << simulator->warnings()[0];
  for (int n = 0; n < 800; ++n) simulator->step();
  const RecordedRow row = row_of(simulator->view());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(row.sensors[i].force_W.z, 0.981, 0.02) << i;
    EXPECT_GT(row.sensors[i].polygons, 3) << i;
    EXPECT_TRUE(row.sensors[i].readings.empty());
  }
}

constexpr const char* kTwoBalls = R"(<mujoco><asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
  <geom name='floor' type='plane' size='1 1 1'/>
  <body pos='0 0 0.0195'><freejoint/><geom name='ball' type='mesh' mesh='ball'/></body>
  <body pos='.1 0 0.0195'><freejoint/><geom type='mesh' mesh='ball'/></body>
  <body pos='.2 0 0.0195'><freejoint/><geom name='round' type='sphere' size='.02'/></body></worldbody></mujoco>)";

TEST_F(OldScene, PutsOneLayoutOnSeveralGeomsWithoutNames) {
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  const std::string layout = (s.folder / "ball.taxels.json").string();
  const auto simulator = load(kTwoBalls, {{"ball", layout}, {"geom 2", layout}, {"round", layout}});
  EXPECT_EQ(simulator->scene()->sensor_geoms, (std::vector<std::string>{"ball", "body_2", "round"}));
  EXPECT_EQ(simulator->scene()->sensors[0], simulator->scene()->sensors[1]);  // compiled once
  for (int n = 0; n < 600; ++n) simulator->step();
  const double weight = 9.81 * 1000 * make_sphere(0.02, 0.008).volume();
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(row_of(simulator->view()).sensors[i].force_W.z, weight, 0.02 * weight) << i;
  // The warning contains the distance between the surface of the sphere and that of the layout.
  ASSERT_EQ(simulator->warnings().size(), 1U);
  EXPECT_TRUE(has(simulator->warnings()[0], "geom \"round\" has no mesh")) << simulator->warnings()[0];
  EXPECT_TRUE(has(simulator->warnings()[0], "mm apart")) << simulator->warnings()[0];
  // The saved scene, a patch of the original, declares all three with copies of the layout, and runs in the same way.
  save_scene(*simulator, s.folder / "out" / "with taxels.xml");
  EXPECT_TRUE(std::filesystem::exists(s.folder / "out/ball.taxels.json"));
  const auto again = Simulator::load(s.folder / "out" / "with taxels.xml");
  ASSERT_EQ(again->scene()->sensor_geoms, simulator->scene()->sensor_geoms);
  for (int n = 0; n < 600; ++n) again->step();
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(row_of(again->view()).sensors[i].force_W.z, row_of(simulator->view()).sensors[i].force_W.z, 1e-4) << i;
}

TEST_F(OldScene, RefusesTwoLayoutsOnAGeom) {
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  const std::string layout = (s.folder / "ball.taxels.json").string(), scene = (s.folder / "scene.xml").string();
  EXPECT_EQ(test::complaint_of([&] {
              load(kTwoBalls, {{"ball", layout}, {"ball", layout}});
            }),
            scene + ": two layouts are attached to geom \"ball\": a geom takes one");
  std::string declared = kTwoBalls;
  declared.insert(declared.find("<asset>"), test::sensor_extension("ball"));
  EXPECT_EQ(test::complaint_of([&] {
              load(declared, {{"ball", layout}});
            }),
            scene + ": geom \"ball\" has a sensor already, \"ball\": a geom takes one layout");
}

TEST_F(OldScene, ReportsHashAndSurfaceDistanceOfALayoutForAnotherMesh) {
  s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  s.add_sensor("other", make_sphere(0.021, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
  Layout layout = read_layout(s.folder / "other.taxels.json");
  layout.mesh.sha256 = load_mesh(s.folder / "other.obj").sha256;
  write_layout(s.folder / "other.taxels.json", layout);
  const auto simulator = load(kTwoBalls, {{"ball", (s.folder / "other.taxels.json").string()}});
  ASSERT_EQ(simulator->warnings().size(), 1U);
  const std::string warning = simulator->warnings()[0];
  EXPECT_TRUE(has(warning, "the hash of its file differs")) << warning;
  EXPECT_TRUE(has(warning, "up to 1 mm apart")) << warning;  // corners of one surface are 1 mm off the other
}

}  // namespace
}  // namespace taxel
