// Properties of every contact: it equals the brute-force oracle, and its polygons are valid.
#include <gtest/gtest.h>

#include "fixtures/brute_force_contact.h"
#include "property_bodies.h"

namespace taxel {
namespace {

BruteForceContact oracle(const HydroBody& soft, const HydroBody& rigid, const Pose& X_SR) {
  if (const auto* mesh = std::get_if<RigidMesh>(&rigid.geometry))
    return brute_force_contact(field_of(soft), mesh->index->mesh(), X_SR);
  return brute_force_contact(field_of(soft), X_SR);
}

/// Returns a contact without its depth pieces (tests/unit/hydro/depth_pieces_test.cpp), as the part that the tets of
/// the bodies share.
Contact without_pieces(Contact contact) {
  std::erase_if(contact.surface.polygons, [](const ContactPolygon& polygon) { return polygon.tet < 0; });
  contact.wrench = traction(contact.surface, {}, {}).wrench;
  return contact;
}

/// Expects equal results of the kernel and the oracle, relative to the size of the contact.
void expect_equal(const Contact& found, const BruteForceContact& expected) {
  ASSERT_EQ(found.surface.polygons.size(), static_cast<std::size_t>(expected.polygons));
  ASSERT_NEAR(found.surface.area(), expected.area, 1e-9 * expected.area);
  ASSERT_LE(glm::distance(found.wrench.force, expected.force), 1e-9 * expected.push);
  ASSERT_LE(glm::distance(found.wrench.torque, expected.torque), 1e-9 * expected.push * kSize);
}

class EveryShape : public testing::TestWithParam<ShapeType> {};

TEST_P(EveryShape, EqualsTheBruteForceOracle) {
  const HydroBodyPtr soft = all_faces(soft_body()), rigid = rigid_body(GetParam());
  int touching = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WS = soft_pose(i), X_WR = rigid_pose(X_WS, i);
    const BruteForceContact expected = oracle(*soft, *rigid, X_WS.inverse() * X_WR);
    const Contact found = without_pieces(touch(*soft, *rigid, X_WS, X_WR));
    SCOPED_TRACE(testing::Message() << "pose " << i);
    ASSERT_NO_FATAL_FAILURE(expect_equal(found, expected));
    touching += expected.polygons > 0 ? 1 : 0;
  }
  EXPECT_GE(touching, kPoses / 2);
}

TEST(TwoSoftBodies, EqualTheBruteForceOracle) {
  const HydroBodyPtr pad = all_faces(soft_body()),
                     other_pad = shape_body(ShapeType::mesh, all_faces(soft_material(2e5, 0.2 * kSize)));
  Material material = all_faces(soft_material(3e5));
  material.field = FieldKind::medial_axis;
  for (const HydroBodyPtr& other :
       {other_pad, shape_body(ShapeType::box, material), shape_body(ShapeType::ellipsoid, material),
        shape_body(ShapeType::capsule, material)}) {
    int touching = 0;
    for (int i = 0; i < 50; ++i) {
      const Pose X_WA = soft_pose(i), X_WB = rigid_pose(X_WA, i);
      const BruteForceContact expected = brute_force_contact(field_of(*pad), field_of(*other), X_WA.inverse() * X_WB);
      SCOPED_TRACE(testing::Message() << "pose " << i);
      ASSERT_NO_FATAL_FAILURE(expect_equal(without_pieces(touch(*pad, *other, X_WA, X_WB)), expected));
      touching += expected.polygons > 0 ? 1 : 0;
    }
    EXPECT_GE(touching, 20);
  }
}

/// Every polygon must be flat, convex and counterclockwise about its normal, and its stored numbers must equal those of
/// its vertices.
TEST_P(EveryShape, PolygonsMatchTheirStoredValues) {
  const HydroBodyPtr soft = all_faces(soft_body()), rigid = rigid_body(GetParam());
  for (int i = 0; i < kPoses; i += 4) {
    const Pose X_WS = soft_pose(i), X_WR = rigid_pose(X_WS, i);
    const bool swap = i % 8 == 0;
    const ContactSurface s = swap ? touch(*rigid, *soft, X_WR, X_WS).surface : touch(*soft, *rigid, X_WS, X_WR).surface;
    ASSERT_EQ(s.vertices.size(), s.pressure.size());
    for (const ContactPolygon& polygon : s.polygons) {
      const auto first = static_cast<std::size_t>(polygon.first), count = static_cast<std::size_t>(polygon.count);
      ASSERT_GE(count, 3u);
      const double size = std::sqrt(polygon.area);
      dvec3 area{0};
      for (std::size_t k = 0; k < count; ++k) {
        const dvec3 &a = s.vertices[first + k], &b = s.vertices[first + (k + 1) % count];
        area += 0.5 * glm::cross(a - polygon.centroid, b - polygon.centroid);
        const double p = polygon.pressure + glm::dot(polygon.gradient, a - polygon.centroid);
        ASSERT_NEAR(s.pressure[first + k], std::max(0.0, p), 1e-9 * field_of(*soft).max_pressure());
        ASSERT_GE(s.pressure[first + k], 0);
        ASSERT_NEAR(glm::dot(polygon.normal, a - polygon.centroid), 0, 1e-9 * kSize);
      }
      ASSERT_NEAR(glm::dot(area, polygon.normal), polygon.area, 1e-5 * size * kSize);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rigid, EveryShape,
                         testing::Values(ShapeType::plane, ShapeType::sphere, ShapeType::box, ShapeType::capsule,
                                         ShapeType::cylinder, ShapeType::ellipsoid, ShapeType::mesh));

}  // namespace
}  // namespace taxel
