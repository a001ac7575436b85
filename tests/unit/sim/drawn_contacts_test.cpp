// The contact surfaces and forces that the plugin adds to the scenes of MuJoCo's visualizer.
#include "core/sim/plugin/drawn_contacts.h"

#include <gtest/gtest.h>

#include <memory>

#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::SensorScene;

constexpr double kRadius = 0.02;

/// A scene of MuJoCo's visualizer with the decorative geoms of a state.
class Drawing {
 public:
  Drawing(const mjModel& m, mjData& d, std::initializer_list<int> flags, int room = 10000) {
    mjv_defaultScene(&scene);
    mjv_makeScene(&m, &scene, room);
    mjvOption options;
    mjv_defaultOption(&options);
    for (mjtByte& flag : options.flags) flag = 0;
    for (const int flag : flags) options.flags[flag] = 1;
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    mjv_updateScene(&m, &d, &options, nullptr, &camera, mjCAT_DECOR, &scene);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;
  ~Drawing() { mjv_freeScene(&scene); }

  [[nodiscard]] std::vector<mjvGeom> of(int type) const {
    std::vector<mjvGeom> found;
    for (int i = 0; i < scene.ngeom; ++i)
      if (scene.geoms[i].type == type) found.push_back(scene.geoms[i]);
    return found;
  }
  mjvScene scene;
};

double area_of(const std::vector<mjvGeom>& triangles) {
  double area = 0;
  for (const mjvGeom& t : triangles) {
    const dvec3 x{t.mat[0], t.mat[3], t.mat[6]}, y{t.mat[1], t.mat[4], t.mat[7]};
    area += 0.5 * t.size[0] * t.size[1] * glm::length(glm::cross(x, y));
  }
  return area;
}

/// Soft balls that are pressed into the floor or into each other.
void make_balls(SensorScene& s, const std::vector<std::pair<std::string, std::string>>& balls, double floor) {
  std::string extension, asset, world, declared;
  for (const auto& [name, place] : balls) {
    s.add_sensor(name, make_sphere(kRadius, 0.003), Material{FieldKind::star, 1e5, 0, 0, 0.5});
    extension += "<instance name='" + name + "'>" + key("layout", name + ".taxels.json") + key("geom", name) +
                 key("others", "*") + key("output", "wrench area") + "</instance>";
    asset += "<mesh name='" + name + "' file='" + name + ".obj'/>";
    world += "<body pos='" + place + "'><freejoint/><inertial mass='1' pos='0 0 0' diaginertia='1e-3 1e-3 1e-3'/>" +
             "<geom name='" + name + "' type='mesh' mesh='" + name + "' contype='0' conaffinity='0'/></body>";
    declared += "<plugin plugin='taxel.sensor' instance='" + name + "'/>";
  }
  s.compile("<mujoco><extension><plugin plugin='taxel.sensor'>" + extension + "</plugin></extension><asset>" + asset +
            "</asset><worldbody><geom name='floor' type='plane' size='1 1 1' pos='0 0 " + std::to_string(floor) +
            "'/>" + world + "</worldbody><sensor>" + declared + "</sensor></mujoco>");
  ASSERT_NE(s.model, nullptr) << s.error;
  mj_forward(s.model.get(), s.data.get());
}

TEST(DrawnContacts, SurfaceHasItsAreaAndPlaceAndTheColoursOfThePressure) {
  SensorScene s;
  make_balls(s, {{"ball", "0.1 0.2 0.018"}}, 0);
  const Drawing drawing(*s.model, *s.data, {mjVIS_CONTACTPOINT});
  const std::vector<mjvGeom> triangles = drawing.of(mjGEOM_TRIANGLE);
  ASSERT_GT(triangles.size(), 20U);
  EXPECT_EQ(static_cast<int>(triangles.size()), drawing.scene.ngeom);
  EXPECT_NEAR(area_of(triangles) / s.data->sensordata[6], 1, 1e-4);  // single precision
  float reddest = 0, bluest = 0;
  for (const mjvGeom& t : triangles) {
    EXPECT_NEAR(t.pos[2], 0, 1e-6);
    EXPECT_LT(std::hypot(t.pos[0] - 0.1, t.pos[1] - 0.2), kRadius);
    EXPECT_EQ(t.category, mjCAT_DECOR);
    EXPECT_EQ(t.objid, mj_name2id(s.model.get(), mjOBJ_GEOM, "ball"));
    EXPECT_EQ(t.dataid, mj_name2id(s.model.get(), mjOBJ_GEOM, "floor"));
    reddest = std::max(reddest, t.rgba[0] - t.rgba[2]);
    bluest = std::max(bluest, t.rgba[2] - t.rgba[0]);
  }
  EXPECT_GT(reddest, 0.3F);
  EXPECT_GT(bluest, 0.3F);
}

TEST(DrawnContacts, ForceIsAsLongAsThatOfMuJoCo) {
  SensorScene s;
  make_balls(s, {{"ball", "0.1 0.2 0.018"}}, 0);
  const Drawing drawing(*s.model, *s.data, {mjVIS_CONTACTFORCE});
  const std::vector<mjvGeom> arrows = drawing.of(mjGEOM_ARROW);
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_EQ(drawing.scene.ngeom, 1);
  const double force = s.data->sensordata[2];
  EXPECT_GT(force, 1);
  EXPECT_NEAR(arrows[0].size[2], force * s.model->vis.map.force / s.model->stat.meanmass, 1e-6 * force);
  EXPECT_NEAR(arrows[0].mat[8], 1, 1e-3);  // up
  EXPECT_NEAR(arrows[0].pos[0], 0.1, 1e-4);
}

TEST(DrawnContacts, DrawsOnlyContactsAndOnlyIfTheOptionsAskForThem) {
  SensorScene s;
  make_balls(s, {{"ball", "0 0 0.018"}}, 0);
  EXPECT_EQ(Drawing(*s.model, *s.data, {mjVIS_TEXTURE}).scene.ngeom, 0);
  SensorScene apart;
  make_balls(apart, {{"ball", "0 0 0.03"}}, 0);
  EXPECT_EQ(Drawing(*apart.model, *apart.data, {mjVIS_CONTACTPOINT, mjVIS_CONTACTFORCE}).scene.ngeom, 0);
}

TEST(DrawnContacts, ContactOfTwoSensorsIsDrawnOnce) {
  SensorScene s;
  make_balls(s, {{"lower", "0 0 0.1"}, {"upper", "0.002 0.001 0.137"}}, 0);
  const Drawing drawing(*s.model, *s.data, {mjVIS_CONTACTPOINT, mjVIS_CONTACTFORCE});
  const mjtNum area = s.data->sensordata[6];
  EXPECT_GT(area, 1e-5);
  EXPECT_NEAR(s.data->sensordata[13], area, 1e-9);
  EXPECT_NEAR(area_of(drawing.of(mjGEOM_TRIANGLE)) / area, 1, 1e-4);
  EXPECT_EQ(drawing.of(mjGEOM_ARROW).size(), 1U);
  const int lower = mj_name2id(s.model.get(), mjOBJ_GEOM, "lower"),
            upper = mj_name2id(s.model.get(), mjOBJ_GEOM, "upper");
  for (const mjvGeom& t : drawing.of(mjGEOM_TRIANGLE)) EXPECT_EQ(t.objid + t.dataid, lower + upper);
}

TEST(DrawnContacts, LargestPressureOfAllSensorsHasTheLastColour) {
  SensorScene s;
  make_balls(s, {{"hard", "0 0 0.016"}, {"light", "0.1 0 0.0195"}}, 0);
  const Drawing drawing(*s.model, *s.data, {mjVIS_CONTACTPOINT});
  float hard = -1, light = -1;
  for (const mjvGeom& t : drawing.of(mjGEOM_TRIANGLE))
    (t.pos[0] < 0.05F ? hard : light) = std::max(t.pos[0] < 0.05F ? hard : light, t.rgba[0] - t.rgba[2]);
  EXPECT_GT(hard, 0.3F);
  EXPECT_LT(light, 0.0F);
}

TEST(DrawnContacts, FullSceneIsReportedAsMuJoCoDoes) {
  SensorScene s;
  make_balls(s, {{"ball", "0 0 0.018"}}, 0);
  const Drawing drawing(*s.model, *s.data, {mjVIS_CONTACTPOINT}, 10);
  EXPECT_EQ(drawing.scene.ngeom, 10);
  EXPECT_EQ(drawing.scene.status, 1);
}

TEST(DrawnContacts, CopyOfTheDataDrawsTheSame) {
  SensorScene s;
  make_balls(s, {{"ball", "0 0 0.018"}}, 0);
  DataHandle copy(mj_copyData(nullptr, s.model.get(), s.data.get()));
  const Drawing first(*s.model, *s.data, {mjVIS_CONTACTPOINT}), second(*s.model, *copy, {mjVIS_CONTACTPOINT});
  ASSERT_EQ(first.scene.ngeom, second.scene.ngeom);
  for (int i = 0; i < first.scene.ngeom; ++i) EXPECT_EQ(first.scene.geoms[i].pos[0], second.scene.geoms[i].pos[0]);
}

}  // namespace
}  // namespace taxel
