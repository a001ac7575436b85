// Each instruction set that the kernel is compiled for gives the same bits.
#include "core/hydro/traction_points.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/instruction_sets.h"

namespace taxel {
namespace {

using test::for_each_set;
using test::on_target;

TEST(InstructionSet, GivesTheSameContactSurfaceAsAllOthers) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(1e5, 0.002));
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(0.01), soft_material(2e5), 0.002);
  const auto rigid_ball = make_simple_body(ShapeType::sphere, dvec3(0.01), {}, 0.001);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.01));
  const auto soft_plane = make_simple_body(ShapeType::plane, dvec3(0), soft_material(1e5, 0.01));
  const Pose beside{glm::angleAxis(0.3, glm::normalize(dvec3(1, 2, 3))), dvec3(0.001, -0.013, 0.01)};
  const Pose below{dquat(1, 0, 0, 0), dvec3(0, 0, 0.02)};
  for (const HydroBodyPtr& other : {box, rigid_ball, ball, plane, soft_plane}) {
    const Pose& X_WB = other == plane || other == soft_plane ? below : beside;
    const ContactSurface usual = touch(*finger, *other, Pose{}, X_WB).surface;
    ASSERT_GT(usual.polygons.size(), 10u);
    for_each_set([&](std::int64_t target) {
      const ContactSurface found = on_target(target, [&] { return touch(*finger, *other, Pose{}, X_WB).surface; });
      ASSERT_EQ(found.vertices, usual.vertices);
      ASSERT_EQ(found.pressure, usual.pressure);
      ASSERT_EQ(found.polygons.size(), usual.polygons.size());
      for (std::size_t i = 0; i < usual.polygons.size(); ++i) {
        ASSERT_EQ(found.polygons[i].area, usual.polygons[i].area);
        ASSERT_EQ(found.polygons[i].centroid, usual.polygons[i].centroid);
      }
    });
  }
}

TEST(InstructionSet, GivesTheSameTractionAsAllOthers) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(1e5, 0.002));
  const auto box = make_simple_body(ShapeType::box, dvec3(0.01));
  const Pose beside{glm::angleAxis(0.3, glm::normalize(dvec3(1, 2, 3))), dvec3(0.001, -0.013, 0.01)};
  const ContactSurface surface = touch(*finger, *box, Pose{}, beside).surface;
  const auto evaluate = [&] {
    TractionPoints points;
    points.assign(surface);
    return points.evaluate({3.0, 0.5}, {dvec3(2e-4, 1e-4, -0.01), dvec3(0.3, -0.2, 0.4)});
  };
  const Traction usual = evaluate();
  ASSERT_NE(usual.wrench.force, usual.elastic.force);
  for_each_set([&](std::int64_t target) {
    const Traction found = on_target(target, evaluate);
    EXPECT_EQ(found.wrench.force, usual.wrench.force);
    EXPECT_EQ(found.wrench.torque, usual.wrench.torque);
    EXPECT_EQ(found.secant, usual.secant);
  });
}

}  // namespace
}  // namespace taxel
