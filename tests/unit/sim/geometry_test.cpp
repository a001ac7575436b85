// What is read from a compiled model: frames of meshes, shapes, who would collide.
#include "core/sim/model/geometry.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::SensorScene;

TEST(Geometry, MeshFilePoseBringsFileVerticesToTheCompiledOnes) {
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
  // glm keeps columns, MuJoCo rows
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(X_WG.R[j][i], s.data->geom_xmat[3 * i + j], 1e-14);
}

TEST(Geometry, CompiledMeshIsTheFilesMesh) {
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
  EXPECT_EQ(geom_name(*s.model, 0), "geom 0");
}

TEST(Geometry, ShapesCarryMujocosSizes) {
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

TEST(Geometry, HeightFieldIsRefusedByName) {
  SensorScene s;
  s.compile(R"(<mujoco><asset><hfield name="h" nrow="2" ncol="2" size="1 1 1 1"/></asset><worldbody>
    <geom name="hills" type="hfield" hfield="h"/></worldbody></mujoco>)");
  ASSERT_NE(s.model, nullptr) << s.error;
  try {
    geom_shape(*s.model, 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("hills"), std::string::npos);
  }
}

/// MuJoCo itself is the oracle: balls that all overlap, in every relation of bodies and masks.
TEST(Geometry, WouldCollideAgreesWithMujocosContacts) {
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
