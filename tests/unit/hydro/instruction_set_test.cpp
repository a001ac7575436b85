// One binary, every machine: each instruction set that the kernel is compiled for gives the same bits.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

struct Restored {
  ~Restored() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
  }
};

ContactSurface on_target(std::int64_t target, const HydroBody& a, const HydroBody& b, const Pose& X_WB) {
  const Restored restored;
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return touch(a, b, Pose{}, X_WB).surface;
}

TEST(InstructionSet, AllGiveTheSameBits) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(1e5, 0.002));
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(0.01), soft_material(2e5), 0.002);
  const auto rigid_ball = make_simple_body(ShapeType::sphere, dvec3(0.01), {}, 0.001);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.01));
  const Pose beside{glm::angleAxis(0.3, glm::normalize(dvec3(1, 2, 3))), dvec3(0.001, -0.013, 0.01)};
  const Pose below{dquat(1, 0, 0, 0), dvec3(0, 0, 0.02)};
  const std::int64_t supported = hwy::SupportedTargets();
  int sets = 0;
  for (const HydroBodyPtr& other : {box, rigid_ball, ball, plane}) {
    const Pose& X_WB = other == plane ? below : beside;
    const ContactSurface usual = touch(*finger, *other, Pose{}, X_WB).surface;
    ASSERT_GT(usual.polygons.size(), 10u);
    for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
      const ContactSurface found = on_target(rest & -rest, *finger, *other, X_WB);
      ASSERT_EQ(found.vertices, usual.vertices);
      ASSERT_EQ(found.pressure, usual.pressure);
      ASSERT_EQ(found.polygons.size(), usual.polygons.size());
      for (std::size_t i = 0; i < usual.polygons.size(); ++i) {
        ASSERT_EQ(found.polygons[i].area, usual.polygons[i].area);
        ASSERT_EQ(found.polygons[i].centroid, usual.polygons[i].centroid);
      }
      ++sets;
    }
  }
  EXPECT_GE(sets, 4);
}

}  // namespace
}  // namespace taxel
