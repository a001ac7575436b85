// What holds for every contact: it equals the brute-force oracle, forces come in pairs, and no frame is special.
#include <gtest/gtest.h>

#include "fixtures/brute_force_contact.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kSize = 0.01;  // of all bodies here, about [m]
constexpr int kPoses = 200;

/// A pad on a lopsided ellipsoid.
HydroBodyPtr soft_body() {
  static const HydroBodyPtr body = [] {
    TriMesh mesh = make_ellipsoid(kSize * dvec3(1.3, 1.0, 0.8), 0.9 * kSize);
    return make_mesh_body(std::move(mesh), soft_material(1e5, 0.3 * kSize));
  }();
  return body;
}

const PressureField& field_of(const HydroBody& body) {
  return *std::get<SoftBody>(body.geometry).field;
}

/// A sphere with dents and bumps.
TriMesh lumpy_mesh() {
  const TriMesh sphere = make_icosphere(kSize, 2);
  std::vector<dvec3> vertices = sphere.vertices();
  const CounterRng rng(5);
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] *= 0.6 + 0.6 * rng.uniform(v);
  return {std::move(vertices), sphere.faces()};
}

HydroBodyPtr rigid_body(ShapeType type) {
  switch (type) {
    case ShapeType::plane:
      return make_simple_body(type, dvec3(0));
    case ShapeType::sphere:
      return make_simple_body(type, dvec3(kSize), {}, 0.7 * kSize);
    case ShapeType::box:
      return make_simple_body(type, kSize * dvec3(1.0, 0.8, 0.6));
    case ShapeType::capsule:
      return make_simple_body(type, kSize * dvec3(0.6, 0.7, 0), {}, 0.7 * kSize);
    case ShapeType::cylinder:
      return make_simple_body(type, kSize * dvec3(0.7, 0.8, 0), {}, 0.7 * kSize);
    case ShapeType::ellipsoid:
      return make_simple_body(type, kSize * dvec3(1.2, 0.7, 0.5), {}, 0.7 * kSize);
    default:
      return make_mesh_body(lumpy_mesh());
  }
}

Pose soft_pose(int i) {
  return random_pose(11, i, 10 * kSize);
}

/// Near the soft body: about three quarters of these poses touch it.
Pose rigid_pose(const Pose& X_WS, int i) {
  return X_WS * random_pose(12, i, 1.2 * kSize);
}

BruteForceContact oracle(const HydroBody& soft, const HydroBody& rigid, const Pose& X_SR) {
  if (const auto* mesh = std::get_if<RigidMesh>(&rigid.geometry))
    return brute_force_contact(field_of(soft), mesh->index->mesh(), X_SR);
  return brute_force_contact(field_of(soft), X_SR);
}

class EveryShape : public testing::TestWithParam<ShapeType> {};

TEST_P(EveryShape, EqualsTheBruteForceOracle) {
  const HydroBodyPtr soft = soft_body(), rigid = rigid_body(GetParam());
  int touching = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WS = soft_pose(i), X_WR = rigid_pose(X_WS, i);
    const BruteForceContact expected = oracle(*soft, *rigid, X_WS.inverse() * X_WR);
    const Contact found = touch(*soft, *rigid, X_WS, X_WR);
    ASSERT_EQ(found.surface.polygons.size(), static_cast<std::size_t>(expected.polygons)) << "pose " << i;
    ASSERT_NEAR(found.surface.area(), expected.area, 1e-9 * expected.area) << "pose " << i;
    ASSERT_LE(glm::distance(found.wrench.force, expected.force), 1e-9 * expected.push) << "pose " << i;
    ASSERT_LE(glm::distance(found.wrench.torque, expected.torque), 1e-9 * expected.push * kSize) << "pose " << i;
    touching += expected.polygons > 0 ? 1 : 0;
  }
  EXPECT_GE(touching, kPoses / 2);
}

double push(const ContactSurface& surface) {
  double sum = 0;
  for (const ContactPolygon& p : surface.polygons) sum += p.area * p.pressure;
  return sum;
}

/// A wrench at the origin of a frame of pose X_WA, in the world at the world's origin.
Wrench in_world(const Wrench& wrench_A, const Pose& X_WA) {
  const dvec3 force = X_WA.rotate(wrench_A.force);
  return {force, X_WA.rotate(wrench_A.torque) + glm::cross(X_WA.p, force)};
}

TEST_P(EveryShape, ActionEqualsReactionWhenTheBodiesSwap) {
  const HydroBodyPtr soft = soft_body(), rigid = rigid_body(GetParam());
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WS = soft_pose(i), X_WR = rigid_pose(X_WS, i);
    const Contact on_soft = touch(*soft, *rigid, X_WS, X_WR), on_rigid = touch(*rigid, *soft, X_WR, X_WS);
    const double scale = push(on_soft.surface);
    const Wrench a = in_world(on_soft.wrench, X_WS), b = in_world(on_rigid.wrench, X_WR);
    ASSERT_EQ(on_soft.surface.polygons.size(), on_rigid.surface.polygons.size()) << "pose " << i;
    ASSERT_NEAR(on_soft.surface.area(), on_rigid.surface.area(), 1e-10 * on_soft.surface.area());
    ASSERT_LE(glm::length(a.force + b.force), 1e-10 * scale) << "pose " << i;
    ASSERT_LE(glm::length(a.torque + b.torque), 1e-10 * scale * kSize * 10) << "pose " << i;
  }
}

TEST_P(EveryShape, ACommonMotionChangesNothing) {
  const HydroBodyPtr soft = soft_body(), rigid = rigid_body(GetParam());
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_WS = soft_pose(i), X_WR = rigid_pose(X_WS, i), motion = random_pose(13, i, 20 * kSize);
    const Contact here = touch(*soft, *rigid, X_WS, X_WR), there = touch(*soft, *rigid, motion * X_WS, motion * X_WR);
    const double scale = push(here.surface);
    ASSERT_NEAR(here.surface.area(), there.surface.area(), 1e-10 * here.surface.area()) << "pose " << i;
    ASSERT_LE(glm::distance(here.wrench.force, there.wrench.force), 1e-10 * scale) << "pose " << i;
    ASSERT_LE(glm::distance(here.wrench.torque, there.wrench.torque), 1e-10 * scale * kSize) << "pose " << i;
  }
}

/// Every polygon: flat, convex, turning about its normal, its stored numbers those of its vertices.
TEST_P(EveryShape, PolygonsAreWhatTheySay) {
  const HydroBodyPtr soft = soft_body(), rigid = rigid_body(GetParam());
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
