// Geometry read from a compiled model: frames of meshes, shapes, and pairs that would collide.
#include "core/sim/model/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::SensorScene;

TEST(Geometry, TransformsFileVerticesToTheCompiledMesh) {
  SensorScene s;
  const TriMesh mesh = make_fingertip();
  save_mesh(s.folder / "tip.obj", mesh);
  s.compile(R"(<mujoco><asset><mesh name="tip" file="tip.obj"/></asset><worldbody>
    <body pos="0.1 -0.2 0.3" quat="0.5 0.5 -0.5 0.5"><freejoint/>
      <geom name="tip" type="mesh" mesh="tip" pos="0.01 0.02 0.03" quat="0.6 0 0.8 0"/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const mjModel& m = *s.model;
  mj_forward(&m, s.data.get());
  const RigidTransform X_GM(mesh_file_pose(m, 0)), X_WG(geom_pose(m, *s.data, 0));
  ASSERT_EQ(m.mesh_vertnum[0], mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const float* compiled = m.mesh_vert + 3 * v;
    const dvec3 vertex = X_GM(mesh.vertices()[static_cast<std::size_t>(v)]);
    EXPECT_LT(glm::distance(vertex, dvec3(compiled[0], compiled[1], compiled[2])), 2e-7 * 0.03);
  }
  const mjtNum* p = s.data->geom_xpos;
  EXPECT_LT(glm::distance(X_WG.p, dvec3(p[0], p[1], p[2])), 1e-15);
  // The order differs: glm stores columns, MuJoCo stores rows.
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(X_WG.R[j][i], s.data->geom_xmat[3 * i + j], 1e-14);
}

TEST(Geometry, ReadsTheCompiledMeshLikeTheFile) {
  SensorScene s;
  const TriMesh mesh = make_fingertip();
  save_mesh(s.folder / "tip.stl", mesh);
  s.compile(R"(<mujoco><asset><mesh name="tip" file="tip.stl"/></asset><worldbody>
    <geom type="mesh" mesh="tip"/></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const TriMesh compiled = compiled_mesh(*s.model, 0);
  EXPECT_EQ(compiled.face_count(), mesh.face_count());
  EXPECT_TRUE(compiled.closed());
  EXPECT_NEAR(compiled.volume(), mesh.volume(), 1e-5 * mesh.volume());
  EXPECT_EQ(geom_name(*s.model, 0), "world, tip");
}

TEST(Geometry, ReadsTheSizesOfShapes) {
  SensorScene s;
  s.compile(R"(<mujoco><worldbody>
    <geom name="b" type="box" size="1 2 3"/><geom name="c" type="capsule" size="0.5 2"/>
    <geom name="p" type="plane" size="0 0 1"/></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(geom_shape(*s.model, 0).type, ShapeType::box);
  EXPECT_EQ(geom_shape(*s.model, 0).size, dvec3(1, 2, 3));
  EXPECT_EQ(geom_shape(*s.model, 1).type, ShapeType::capsule);
  EXPECT_EQ(geom_shape(*s.model, 1).size.x, 0.5);
  EXPECT_EQ(geom_shape(*s.model, 1).size.y, 2);
  EXPECT_EQ(geom_shape(*s.model, 2).type, ShapeType::plane);
}

/// MuJoCo itself is the oracle: a small ball just above our surface touches nothing, and just below it touches.
TEST(Geometry, ReadsTheHeightFieldThatMujocoCollidesWith) {
  SensorScene s;
  s.compile(R"(<mujoco><asset><hfield name="h" nrow="4" ncol="5" size="0.4 0.3 0.1 0.05" elevation="
      0 .3 .8 .2 .1  .5 1 .4 .3 .6  .2 .1 .9 .5 0  .7 .2 .3 .8 .4"/></asset><worldbody>
    <geom name="hills" type="hfield" hfield="h" pos="0.1 0.2 0.3" quat="0.9 0.1 -0.3 0.2"/>
    <body><freejoint/><geom name="ball" size="0.001"/></body></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const Shape shape = geom_shape(*s.model, 0);
  EXPECT_STREQ(shape.rigid_only, "a height field");
  ASSERT_TRUE(shape.mesh->closed());
  mj_forward(s.model.get(), s.data.get());
  const Pose X_WG = geom_pose(*s.model, *s.data, 0);
  constexpr double kBallRadius = 0.001, kGap = 2e-5;
  int checked = 0;
  for (int f = 0; f < shape.mesh->face_count(); ++f) {
    const dvec3 n = shape.mesh->face_normals()[static_cast<std::size_t>(f)];
    if (n.z < 0.1) continue;  // only the top, because MuJoCo has no sides for balls next to the grid
    for (const dvec3& weight : {dvec3(0.6, 0.2, 0.2), dvec3(0.2, 0.6, 0.2), dvec3(0.2, 0.2, 0.6)}) {
      const dvec3 x = weight.x * shape.mesh->vertex(f, 0) + weight.y * shape.mesh->vertex(f, 1) +
                      weight.z * shape.mesh->vertex(f, 2);
      for (const double gap : {kGap, -kGap}) {
        const dvec3 center = X_WG * (x + (kBallRadius + gap) * n);
        for (int i = 0; i < 3; ++i) s.data->qpos[i] = center[i];
        mj_forward(s.model.get(), s.data.get());
        EXPECT_EQ(s.data->ncon > 0, gap < 0) << f << " " << gap;
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 3 * 4 * 2 * 3 * 2);
}

/// Our own signed distance function: an ellipsoid. It is not the true distance, which is not needed.
namespace egg {
constexpr double kMost = 0.05;
const char* const kAttributes[1] = {"length"};
double length_of(const char* text) {
  return text != nullptr && *text != '\0' ? std::atof(text) : 0.04;
}
mjtNum distance(const mjtNum p[3], double length) {
  const dvec3 x = dvec3(p[0] - 0.01, p[1], p[2]) / dvec3(length, 0.02, 0.03);
  return 0.02 * (glm::length(x) - 1);
}
double lengths[8];  // attributes of the instances, which a plugin would store in its data

void register_plugin() {
  static bool once = false;
  if (std::exchange(once, true)) return;
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = "test.sdf.egg";
  plugin.capabilityflags |= mjPLUGIN_SDF;
  plugin.nattribute = 1;
  plugin.attributes = kAttributes;
  plugin.nstate = +[](const mjModel*, int) { return 0; };
  plugin.init = +[](const mjModel* m, mjData*, int instance) {
    lengths[instance] = length_of(mj_getPluginConfig(m, instance, "length"));
    return 0;
  };
  plugin.reset = +[](const mjModel*, mjtNum*, void*, int) {};
  plugin.compute = +[](const mjModel*, mjData*, int, int) {};
  plugin.sdf_distance = +[](const mjtNum p[3], const mjData*, int instance) { return distance(p, lengths[instance]); };
  plugin.sdf_gradient = +[](mjtNum gradient[3], const mjtNum p[3], const mjData*, int instance) {
    const dvec3 s(lengths[instance], 0.02, 0.03), x = dvec3(p[0] - 0.01, p[1], p[2]) / s;
    for (int i = 0; i < 3; ++i) gradient[i] = 0.02 * x[i] / s[i] / std::max(1e-9, glm::length(x));
  };
  plugin.sdf_staticdistance = +[](const mjtNum p[3], const mjtNum* attribute) { return distance(p, attribute[0]); };
  plugin.sdf_attribute =
      +[](mjtNum attribute[], const char*[], const char* value[]) { attribute[0] = length_of(value[0]); };
  plugin.sdf_aabb = +[](mjtNum aabb[6], const mjtNum* attribute) {
    const mjtNum box[6] = {0.01, 0, 0, attribute[0], 0.02, attribute[0] > kMost ? 0.01 : 0.03};  // too flat
    std::copy(box, box + 6, aabb);
  };
  mjp_registerPlugin(&plugin);
}
}  // namespace egg

std::string egg_scene(const std::string& length) {
  return R"(<mujoco><extension><plugin plugin="test.sdf.egg"><instance name="egg"><config key="length" value=")" +
         length +
         R"("/></instance></plugin></extension>
    <asset><mesh name="egg"><plugin instance="egg"/></mesh></asset><worldbody>
      <geom name="ball" size="0.01" pos="1 1 1"/>
      <body pos="0.3 0 0.1" quat="0.8 0.2 0.1 0.5"><freejoint/>
        <geom name="egg" type="sdf" mesh="egg"><plugin instance="egg"/></geom></body></worldbody></mujoco>)";
}

TEST(Geometry, ReadsASignedDistanceFunctionAsItsZeroLevel) {
  SensorScene s;
  egg::register_plugin();
  s.compile(egg_scene("0.045"));
  ASSERT_NE(s.model, nullptr) << s.error;
  mj_forward(s.model.get(), s.data.get());
  const Shape shape = geom_shape(*s.model, 1, 0.003);
  EXPECT_STREQ(shape.rigid_only, "a signed distance function");
  ASSERT_TRUE(shape.mesh->closed());
  const double volume = 4.0 / 3 * kPi * 0.045 * 0.02 * 0.03;
  EXPECT_NEAR(shape.mesh->volume(), volume, 0.02 * volume);
  EXPECT_GT(geom_shape(*s.model, 1, 0.0015).mesh->face_count(), 3 * shape.mesh->face_count());
  // MuJoCo's own distance, in the frame of the function before the mesh was centred.
  const mjpPlugin* plugin = mjc_getSDF(s.model.get(), 1);
  int instance = s.model->geom_plugin[1];
  mjtGeom type = mjGEOM_SDF;
  const mjSDF sdf{&plugin, &instance, mjSDFTYPE_SINGLE, nullptr, nullptr, &type};
  const int mesh = s.model->geom_dataid[1];
  const mjtNum *p = s.model->mesh_pos + 3 * mesh, *q = s.model->mesh_quat + 4 * mesh;
  const Pose X_FG{dquat(q[0], q[1], q[2], q[3]), dvec3(p[0], p[1], p[2])};
  for (const dvec3& v : shape.mesh->vertices()) {
    const dvec3 x = X_FG * v;
    const mjtNum point[3] = {x.x, x.y, x.z};
    EXPECT_NEAR(mjc_distance(s.model.get(), s.data.get(), &sdf, point), 0, 2e-3 * 0.003);
  }
}

TEST(Geometry, NamesABadSignedDistanceFunction) {
  SensorScene s;
  egg::register_plugin();
  s.compile(egg_scene("0.051"));
  ASSERT_NE(s.model, nullptr) << s.error;
  try {
    geom_shape(*s.model, 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("geom \"egg\": its distance function is negative"), std::string::npos)
        << error.what();
  }
}

/// A soft block on flat height fields and functions weighs as much as on a box.
TEST(Geometry, CarriesSensorsOnHeightFields) {
  SensorScene s;
  s.add_sensor("block", make_box({0.03, 0.03, 0.015}), {FieldKind::pad, 2e4, 0.005, 20, 0.5});
  const auto force = [&](const std::string& asset, const std::string& ground) {
    s.compile(
        "<mujoco>" + test::sensor_extension("block", test::key("others", "ground") + test::key("output", "wrench")) +
        "<asset><mesh name='block' file='block.obj'/>" + asset + "</asset><worldbody><geom name='ground' " + ground +
        R"( contype='0' conaffinity='0'/><body pos='0 0 0.014'><freejoint/>
        <geom name='block' type='mesh' mesh='block' contype='0' conaffinity='0'/></body></worldbody></mujoco>)");
    EXPECT_NE(s.model, nullptr) << s.error;
    mj_forward(s.model.get(), s.data.get());
    return s.data->sensordata[2];
  };
  const double on_box = force("", "type='box' size='0.2 0.2 0.1' pos='0 0 -0.1'");
  EXPECT_GT(on_box, 1);
  const std::string flat = "<hfield name='h' nrow='3' ncol='3' size='0.2 0.2 0.05 0.1'/>";
  EXPECT_NEAR(force(flat, "type='hfield' hfield='h'"), on_box, 1e-9 * on_box);
}

/// MuJoCo itself is the oracle: balls that all overlap, in every relation of bodies and masks.
TEST(Geometry, PredictsTheContactsOfMujoco) {
  SensorScene s;
  s.compile(R"(<mujoco><default><geom type="sphere" size="1"/></default><worldbody>
    <geom name="w1"/><geom name="w2" contype="2" conaffinity="4"/>
    <body><geom name="static child"/></body>
    <body><freejoint/><geom name="a1"/><geom name="a2" contype="4" conaffinity="2"/>
      <body><geom name="a welded"/></body>
      <body><joint type="hinge"/><geom name="a child" contype="3" conaffinity="3"/>
        <body><joint type="hinge"/><geom name="a grandchild"/></body></body></body>
    <body><freejoint/><geom name="b" contype="0" conaffinity="1"/></body>
    <body><freejoint/><geom name="none" contype="0" conaffinity="0"/></body>
    </worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  const mjModel& m = *s.model;
  mj_forward(&m, s.data.get());
  std::set<std::pair<int, int>> seen;
  for (int c = 0; c < s.data->ncon; ++c) {
    const int a = s.data->contact[c].geom[0], b = s.data->contact[c].geom[1];
    seen.insert(std::minmax(a, b));
  }
  ASSERT_GT(seen.size(), 5u);
  for (int a = 0; a < m.ngeom; ++a)
    for (int b = a + 1; b < m.ngeom; ++b)
      EXPECT_EQ(would_collide(m, a, b), seen.contains({a, b})) << geom_name(m, a) << " and " << geom_name(m, b);
}

}  // namespace
}  // namespace taxel
