// Properties of every pair of bodies: forces come in pairs, and neither the order of the bodies nor the frame has an
// effect.
#include <gtest/gtest.h>

#include "property_bodies.h"

namespace taxel {
namespace {

struct BodyPair {
  const char* name;
  HydroBodyPtr (*a)();
  HydroBodyPtr (*b)();
};

std::ostream& operator<<(std::ostream& out, const BodyPair& pair) {
  return out << pair.name;
}

template <ShapeType type>
HydroBodyPtr rigid() {
  return rigid_body(type);
}
/// Returns a body with a medial-axis field. A half-space is 5 mm thick.
template <ShapeType type>
HydroBodyPtr soft() {
  Material material = soft_material(1e5, type == ShapeType::plane ? 0.5 * kSize : 0);
  material.field = FieldKind::medial_axis;
  return shape_body(type, material);
}

/// Returns another pad, on a dented sphere and twice as stiff.
HydroBodyPtr soft_pad() {
  return shape_body(ShapeType::mesh, soft_material(2e5, 0.2 * kSize));
}

class EveryPair : public testing::TestWithParam<BodyPair> {
 protected:
  HydroBodyPtr a_ = GetParam().a(), b_ = GetParam().b();

  Contact a_touches_b(const Pose& X_WA, const Pose& X_WB) const { return touch(*a_, *b_, X_WA, X_WB); }
  Contact b_touches_a(const Pose& X_WA, const Pose& X_WB) const { return touch(*b_, *a_, X_WB, X_WA); }
};

// Rounding in the poses, up to 20 sizes from the origin, moves edges by up to 1e-16 m. Contacts narrower than 1/500 of
// the bodies use the tolerance of a contact of this width.
constexpr double kNarrow = 2e-3 * kSize;

double area_scale(const ContactSurface& surface) {
  return std::max(surface.area(), kNarrow * kNarrow);
}
/// Returns the integral of the pressure without direction. For a narrow contact it is E (width/size)^2 over width^2.
double push_scale(const ContactSurface& surface) {
  double sum = 0;
  for (const ContactPolygon& p : surface.polygons) sum += p.area * p.pressure;
  return std::max(sum, 1e5 * kNarrow * kNarrow * 1e-6);
}

/// Returns the number of polygons in tets. Depth pieces are not counted, because rounding may decide whether a very
/// thin piece remains.
std::ptrdiff_t polygons_of_tets(const ContactSurface& surface) {
  return std::count_if(surface.polygons.begin(), surface.polygons.end(),
                       [](const ContactPolygon& polygon) { return polygon.tet >= 0 || polygon.tet_b >= 0; });
}

/// Returns the relative error of the invariants by rounding. Outside its tets, a soft box without a pad has only the
/// pressure of the last tet on a traversal, and rounding may decide which tet this is (PressureAt,
/// kernel/depth_march.h).
double tolerance(const HydroBody& a, const HydroBody& b, const ContactSurface& one, const ContactSurface& other) {
  const auto is_pad = [](const HydroBody& body) {
    const auto* soft = std::get_if<SoftBody>(&body.geometry);
    return soft == nullptr || soft->depth != nullptr;
  };
  const auto all_in_tets = [](const ContactSurface& surface) {
    return polygons_of_tets(surface) == static_cast<std::ptrdiff_t>(surface.polygons.size());
  };
  return (is_pad(a) && is_pad(b)) || (all_in_tets(one) && all_in_tets(other)) ? 1e-10 : 1e-3;
}

/// Returns a wrench at the origin of a frame of pose X_WA as a wrench at the world's origin, in the world frame.
Wrench in_world(const Wrench& wrench_A, const Pose& X_WA) {
  const dvec3 force = X_WA.rotate(wrench_A.force);
  return {force, X_WA.rotate(wrench_A.torque) + glm::cross(X_WA.p, force)};
}

TEST_P(EveryPair, GivesOppositeForcesIfTheBodiesSwap) {
  int touching = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WA = soft_pose(i), X_WB = rigid_pose(X_WA, i);
    const Contact on_a = a_touches_b(X_WA, X_WB), on_b = b_touches_a(X_WA, X_WB);
    const double scale = push_scale(on_a.surface), part = tolerance(*a_, *b_, on_a.surface, on_b.surface);
    const Wrench a = in_world(on_a.wrench, X_WA), b = in_world(on_b.wrench, X_WB);
    ASSERT_EQ(polygons_of_tets(on_a.surface), polygons_of_tets(on_b.surface)) << "pose " << i;
    ASSERT_NEAR(on_a.surface.area(), on_b.surface.area(), part * area_scale(on_a.surface)) << "pose " << i;
    ASSERT_LE(glm::length(a.force + b.force), part * scale) << "pose " << i;
    ASSERT_LE(glm::length(a.torque + b.torque), part * scale * kSize * 10) << "pose " << i;
    touching += on_a.surface.empty() ? 0 : 1;
  }
  EXPECT_GE(touching, kPoses / 3);
}

/// Returns a velocity field v + w x r in the world as the twist at the origin of a frame of pose X, in this frame.
Twist in_frame(const Twist& V_W, const Pose& X) {
  const dmat3 R = glm::transpose(X.rotation());
  return {R * (V_W.linear + glm::cross(V_W.angular, X.p)), R * V_W.angular};
}

/// With damping that nowhere reaches its limit, the traction is a polynomial, which is integrated exactly.
TEST_P(EveryPair, GivesOppositeForcesInMotion) {
  const PairProperties pair{1.0, 0};
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WA = soft_pose(i), X_WB = rigid_pose(X_WA, i);
    const dvec3 spin = random_pose(14, i, 1).p, drift = 0.3 * random_pose(15, i, 1).p;
    const Twist V{drift - glm::cross(spin, X_WA.p), spin};  // velocity of A relative to B, about A's origin
    const Twist back{-V.linear, -V.angular};
    const Contact on_a = a_touches_b(X_WA, X_WB), on_b = b_touches_a(X_WA, X_WB);
    const double scale = push_scale(on_a.surface), part = tolerance(*a_, *b_, on_a.surface, on_b.surface);
    const Wrench a = in_world(traction(on_a.surface, pair, in_frame(V, X_WA)).wrench, X_WA);
    const Wrench b = in_world(traction(on_b.surface, pair, in_frame(back, X_WB)).wrench, X_WB);
    ASSERT_LE(glm::length(a.force + b.force), part * scale) << "pose " << i;
    ASSERT_LE(glm::length(a.torque + b.torque), part * scale * kSize * 10) << "pose " << i;
    if (on_a.surface.area() < kNarrow * kNarrow) continue;
    // Damping has an effect.
    ASSERT_GT(glm::distance(a.force, in_world(on_a.wrench, X_WA).force), 1e-6 * scale) << "pose " << i;
  }
}

TEST_P(EveryPair, GivesTheSameForceInACommonMotion) {
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WA = soft_pose(i), X_WB = rigid_pose(X_WA, i), motion = random_pose(13, i, 20 * kSize);
    const Contact here = a_touches_b(X_WA, X_WB), moved_contact = a_touches_b(motion * X_WA, motion * X_WB);
    const double scale = push_scale(here.surface), part = tolerance(*a_, *b_, here.surface, moved_contact.surface);
    ASSERT_NEAR(here.surface.area(), moved_contact.surface.area(), part * area_scale(here.surface)) << "pose " << i;
    ASSERT_LE(glm::distance(here.wrench.force, moved_contact.wrench.force), part * scale) << "pose " << i;
    ASSERT_LE(glm::distance(here.wrench.torque, moved_contact.wrench.torque), part * scale * kSize) << "pose " << i;
  }
}

TEST_P(EveryPair, IsNeverAdhesive) {
  int contacts = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WA = soft_pose(i), X_WB = rigid_pose(X_WA, i);
    const Contact c = a_touches_b(X_WA, X_WB);
    contacts += c.surface.polygons.empty() ? 0 : 1;
    for (const double p : c.surface.pressure) ASSERT_GE(p, 0) << "pose " << i;
    for (const ContactPolygon& polygon : c.surface.polygons) ASSERT_GE(polygon.pressure, 0) << "pose " << i;
  }
  EXPECT_GT(contacts, 0);
}

using enum ShapeType;
const BodyPair kPairs[] = {
    {"PadPlane", soft_body, rigid<plane>},
    {"PadSphere", soft_body, rigid<sphere>},
    {"PadBox", soft_body, rigid<box>},
    {"PadCapsule", soft_body, rigid<capsule>},
    {"PadCylinder", soft_body, rigid<cylinder>},
    {"PadEllipsoid", soft_body, rigid<ellipsoid>},
    {"PadMesh", soft_body, rigid<mesh>},
    {"SphereMesh", soft<sphere>, rigid<mesh>},
    {"BoxBox", soft<box>, rigid<box>},
    {"CapsuleEllipsoid", soft<capsule>, rigid<ellipsoid>},
    {"CylinderPlane", soft<cylinder>, rigid<plane>},
    {"EllipsoidSphere", soft<ellipsoid>, rigid<sphere>},
    {"HalfSpaceSphere", soft<plane>, rigid<sphere>},
    {"HalfSpaceBox", soft<plane>, rigid<box>},
    {"HalfSpaceMesh", soft<plane>, rigid<mesh>},
    {"PadPad", soft_body, soft_pad},
    {"PadSoftBox", soft_body, soft<box>},
    {"SoftSphereSoftSphere", soft<sphere>, soft<sphere>},
    {"SoftBoxSoftCapsule", soft<box>, soft<capsule>},
    {"SoftEllipsoidSoftCylinder", soft<ellipsoid>, soft<cylinder>},
    {"HalfSpacePad", soft<plane>, soft_body},
    {"HalfSpaceSoftBox", soft<plane>, soft<box>},
};

INSTANTIATE_TEST_SUITE_P(Property, EveryPair, testing::ValuesIn(kPairs),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace taxel
