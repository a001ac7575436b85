// Sites, cameras, joints and bodies have MuJoCo's positions, and MuJoCo's numbers of a step are reported.
#include "core/sim/model/scene_view.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::SensorScene;

constexpr const char* kScene = R"(<mujoco><option solver='CG'><flag energy='enable'/></option>
  <statistic center='1 2 3' extent='4' meansize='.25'/><visual><global azimuth='30' elevation='-20' fovy='50'/></visual>
  <default><default class='small'><site size='.01 .02 .03' group='5'/></default></default><worldbody>
  <geom type='plane' size='1 1 1'/><camera name='still' pos='1 0 1' fovy='20'/>
  <body name='ball' pos='0 0 .09'><freejoint name='fly'/><geom size='.1' mass='1'/>
    <camera name='fixed' pos='0 .1 .2' euler='10 20 30'/><camera name='track' mode='track' pos='1 0 0'/>
    <camera name='com' mode='trackcom' pos='0 1 0'/><camera name='flat' projection='orthographic' fovy='.5' pos='0 0 1'/>
    <site name='a' size='.01' pos='.1 0 0' euler='0 0 40'/><site name='b' size='.01'/><site class='small' type='box' rgba='0 1 0 .5'/>
    <site name='unseen' rgba='0 0 0 0'/>
    <body name='flap' pos='0 0 .2'><joint name='hinge' axis='0 1 0' pos='0 0 -.05'/><geom size='.05' pos='.1 0 0'/>
      <camera name='aims' mode='targetbody' target='ball' pos='.3 0 0'/></body></body></worldbody></mujoco>)";

dvec3 at(const mjtNum* p) {
  return {p[0], p[1], p[2]};
}

class MarksOfAScene : public testing::Test {
 protected:
  void SetUp() override {
    s_.compile(kScene);
    ASSERT_NE(s_.model, nullptr) << s_.error;
    for (int i = 0; i < 50; ++i) mj_step(s_.model.get(), s_.data.get());
    mj_forward(s_.model.get(), s_.data.get());
    pose_marks(*s_.model, *s_.data, poses_);
  }
  SensorScene s_;
  MarkPoses poses_;
};

TEST_F(MarksOfAScene, HaveThePositionsOfMujoco) {
  const mjModel& m = *s_.model;
  const mjData& d = *s_.data;
  const SceneMarks marks = scene_marks(m);
  ASSERT_EQ(poses_.cameras.size(), static_cast<std::size_t>(m.ncam));
  for (std::size_t c = 0; c < poses_.cameras.size(); ++c) {
    EXPECT_EQ(poses_.cameras[c].p, at(d.cam_xpos + 3 * c));
    const dmat3 R = poses_.cameras[c].rotation();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(R[j][i], d.cam_xmat[9 * c + static_cast<std::size_t>(3 * i + j)], 1e-12);
  }
  ASSERT_EQ(poses_.bodies.size(), static_cast<std::size_t>(m.nbody));
  ASSERT_EQ(marks.sites.size(), 3U) << "a fully transparent site is invisible";
  for (std::size_t i = 0; i < marks.sites.size(); ++i) {
    const SceneSite& site = marks.sites[i];
    const dvec3 p_W = (poses_.bodies[static_cast<std::size_t>(site.body)] * site.X_BS).p;
    EXPECT_NEAR(glm::distance(p_W, at(d.site_xpos + 3 * i)), 0, 1e-14) << site.name;
  }
  const SceneJointPlace& hinge = marks.joints.at(1);
  EXPECT_EQ(hinge.name, "hinge");
  EXPECT_NEAR(glm::distance(poses_.bodies[static_cast<std::size_t>(hinge.body)] * hinge.p_B, at(d.xanchor + 3)), 0,
              1e-14);
}

TEST_F(MarksOfAScene, EqualTheFile) {
  const SceneMarks marks = scene_marks(*s_.model);
  EXPECT_EQ(marks.sites[0].mesh, marks.sites[1].mesh) << "spheres of one size";
  EXPECT_NE(marks.sites[0].mesh, marks.sites[2].mesh);
  EXPECT_EQ(marks.sites[0].group, 0);
  EXPECT_EQ(marks.sites[2].group, 5);
  EXPECT_EQ(marks.sites[2].name, "site 2");
  EXPECT_NEAR(glm::length(marks.sites[2].mesh->bounds().extent() - dvec3(.02, .04, .06)), 0, 1e-12);
  EXPECT_FLOAT_EQ(marks.sites[2].rgba[3], 0.5f);
  EXPECT_EQ(marks.cameras[0].name, "still");
  EXPECT_EQ(marks.cameras[0].height, 20);
  EXPECT_FALSE(marks.cameras[0].orthographic);
  EXPECT_TRUE(marks.cameras[4].orthographic);
  EXPECT_EQ(marks.cameras[4].height, .5);
  EXPECT_EQ(marks.overview.center_W, dvec3(1, 2, 3));
  EXPECT_EQ(marks.overview.extent, 4);
  EXPECT_EQ(marks.overview.azimuth_deg, 210);
  EXPECT_EQ(marks.overview.elevation_deg, 20);
  EXPECT_EQ(marks.overview.fov_deg, 50);
  EXPECT_EQ(marks.mean_size, .25);
  EXPECT_EQ(marks.dofs, 7);
  EXPECT_EQ(marks.solver, "CG");
}

TEST_F(MarksOfAScene, ReportTheNumbersOfMujocosStep) {
  const mjData& d = *s_.data;
  const StepFacts facts = step_facts(*s_.model, d);
  EXPECT_EQ(facts.contacts, d.ncon);
  EXPECT_GT(facts.contacts, 0) << "the ball lies in the plane";
  EXPECT_EQ(facts.constraints, d.nefc);
  EXPECT_EQ(facts.iterations, std::accumulate(d.solver_niter, d.solver_niter + std::max(1, d.nisland), 0));
  EXPECT_GT(facts.iterations, 0);
  ASSERT_TRUE(facts.energy);
  EXPECT_EQ(facts.energy->potential, d.energy[0]);
  EXPECT_EQ(facts.energy->kinetic, d.energy[1]);
  EXPECT_GT(facts.arena, 0U);
  EXPECT_LE(facts.arena, scene_marks(*s_.model).arena);
}

}  // namespace
}  // namespace taxel
