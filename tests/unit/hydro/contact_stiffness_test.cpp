// The stiffness of a contact is the derivative of its wrench.
#include "core/hydro/contact_stiffness.h"

#include <gtest/gtest.h>

#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kE = 1e5;

RigidTransform pose_in(const Pose& X_WA, const Pose& X_WB) {
  return RigidTransform(X_WA.inverse() * X_WB);
}

/// Expects -dF/dz on A to equal the reported stiffness, for A moving along z.
void expect_derivative(const HydroBody& a, const HydroBody& b, double height, double tolerance) {
  const double step = 1e-6;
  const Contact here = touch(a, b, at_height(height), Pose{});
  const Matrix6 K = contact_stiffness(here.surface, a, b, pose_in(at_height(height), Pose{}));
  const double force_below = touch(a, b, at_height(height - step), Pose{}).wrench.force.z;
  const double force_above = touch(a, b, at_height(height + step), Pose{}).wrench.force.z;
  const double slope = (force_below - force_above) / (2 * step);
  EXPECT_GT(slope, 0);
  EXPECT_NEAR(K[2][2], slope, tolerance * slope);
  EXPECT_GE(stiffness_bound(here.surface).linear, (1 - 1e-12) * K[2][2]);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(K[i][j], K[j][i], 1e-12 * K[2][2]);
}

TEST(ContactStiffness, IsTheSlopeOfTheForce) {
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const HydroBodyPtr soft_floor = make_simple_body(ShapeType::plane, dvec3(0), soft_material(4 * kE, 0.02));
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.05), soft_material(kE), 0.004);
  const HydroBodyPtr stiff_ball = make_simple_body(ShapeType::sphere, dvec3(0.05), soft_material(4 * kE), 0.004);
  const HydroBodyPtr rigid_ball = make_simple_body(ShapeType::sphere, dvec3(0.05), {}, 0.004);
  const HydroBodyPtr box = make_mesh_body(make_box({0.03, 0.02, 0.015}), soft_material(kE, 0.005));
  expect_derivative(*ball, *floor, 0.046, 0.01);
  expect_derivative(*ball, *soft_floor, 0.046, 0.01);
  expect_derivative(*rigid_ball, *soft_floor, 0.046, 0.01);
  expect_derivative(*ball, *stiff_ball, 0.096, 0.01);
  expect_derivative(*stiff_ball, *ball, 0.096, 0.01);
  expect_derivative(*box, *floor, 0.0145, 0.1);  // the rim of a pad yields as its corners move
}

// A1: dF/dx = 2 pi E x (1 - x/R).
TEST(ContactStiffness, EqualsTheClosedFormOfASoftSphereOnAPlane) {
  const double R = 0.05, x = 0.004;
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(R), soft_material(kE), 0.003);
  const Contact contact = touch(*ball, *floor, at_height(R - x), Pose{});
  const Matrix6 K = contact_stiffness(contact.surface, *ball, *floor, pose_in(at_height(R - x), Pose{}));
  const double exact = 2 * kPi * kE * x * (1 - x / R);
  EXPECT_NEAR(K[2][2], exact, 0.01 * exact);
  EXPECT_NEAR(K[0][0], 0, 1e-9 * exact);
}

// A pad of thickness H on a sphere of radius R has p = (E/H)(R - r), also where the rigid plane at depth x is deeper
// than H. The gradient across the plane is (E/H)(R - x)/r, so dF/dx = (E/H) 2 pi integral_(R-x)^R (R - x) dr = (E/H) 2
// pi x (R - x).
TEST(ContactStiffness, IsTheSlopeOfTheForceBeyondTheTets) {
  const double R = 0.02, H = 0.002;
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), soft_material(kE, H), 0.002);
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const HydroBodyPtr box = make_simple_body(ShapeType::box, dvec3(0.03));
  for (const double x : {1.5 * H, 3 * H}) {
    const double exact = kE / H * 2 * kPi * x * (R - x);
    for (const auto& [rigid, X_WB] : {std::pair(floor, Pose{}), std::pair(box, at_height(-0.03))}) {
      const Pose X_WA = at_height(R - x);
      const Contact contact = touch(*ball, *rigid, X_WA, X_WB);
      EXPECT_TRUE(std::any_of(contact.surface.polygons.begin(), contact.surface.polygons.end(),
                              [](const ContactPolygon& p) { return p.tet < 0; }));
      const Matrix6 K = contact_stiffness(contact.surface, *ball, *rigid, pose_in(X_WA, X_WB));
      EXPECT_NEAR(K[2][2], exact, 0.02 * exact) << x;
      const double step = 1e-5;
      const double below = touch(*ball, *rigid, at_height(R - x - step), X_WB).wrench.force.z;
      const double above = touch(*ball, *rigid, at_height(R - x + step), X_WB).wrench.force.z;
      EXPECT_NEAR(K[2][2], (below - above) / (2 * step), 0.02 * exact) << x;
    }
  }
}

// A8: a slab of area L^2 rotated about x through its centre has the rotational stiffness k L^4/12. The slabs are
// springs in series.
TEST(ContactStiffness, AddsBothSlabsOfAStackAndTheirLevers) {
  const double L = 0.06, H = 0.015;
  const HydroBodyPtr slab = make_mesh_body(make_box({L / 2, L / 2, H}), soft_material(kE, 0.004));
  const HydroBodyPtr rigid = make_simple_body(ShapeType::plane, dvec3(0));
  const HydroBodyPtr soft = make_simple_body(ShapeType::plane, dvec3(0), soft_material(3 * kE, 0.006));
  const Pose X = at_height(H - 0.0002);
  for (const auto& [floor, k] : {std::pair(rigid, kE / 0.004), std::pair(soft, 1 / (0.004 / kE + 0.006 / (3 * kE)))}) {
    const Contact contact = touch(*slab, *floor, X, Pose{});
    const Matrix6 K = contact_stiffness(contact.surface, *slab, *floor, pose_in(X, Pose{}));
    EXPECT_NEAR(K[2][2], k * L * L, 0.03 * k * L * L);  // the rim is less stiff
    EXPECT_NEAR(K[3][3], k * std::pow(L, 4) / 12, 0.05 * k * std::pow(L, 4) / 12);
    EXPECT_NEAR(K[4][4], K[3][3], 1e-3 * K[3][3]);
  }
}

/// Returns the elastic energy with A at `height` above B.
double energy_at(const HydroBody& a, const HydroBody& b, double height) {
  const Contact contact = touch(a, b, at_height(height), Pose{});
  return elastic_energy(contact.surface, a, b, pose_in(at_height(height), Pose{}));
}

// U = A (E/H) x^2/2 for a flat rigid box in a half-space, and for two slabs that are springs in series.
TEST(ElasticEnergy, EqualsTheClosedFormsOfSlabs) {
  const double L = 0.06, x = 0.0005;
  const HydroBodyPtr rigid = make_mesh_body(make_box({L / 2, L / 2, 0.015}), {});
  const HydroBodyPtr soft = make_simple_body(ShapeType::plane, dvec3(0), soft_material(3 * kE, 0.006));
  const double one = 0.5 * L * L * 3 * kE / 0.006 * x * x;
  EXPECT_NEAR(energy_at(*rigid, *soft, 0.015 - x), one, 1e-9 * one);
  const HydroBodyPtr slab = make_mesh_body(make_box({L / 2, L / 2, 0.015}), soft_material(kE, 0.004));
  const double both = 0.5 * L * L * x * x / (0.004 / kE + 0.006 / (3 * kE));
  EXPECT_NEAR(energy_at(*slab, *soft, 0.015 - x), both, 0.03 * both);  // the rim is less stiff
}

// The force is the derivative of the energy: exactly in a half-space, elsewhere to the order of x/R.
TEST(ElasticEnergy, IsTheIntegralOfTheForce) {
  const double R = 0.05, x = 0.002;
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const HydroBodyPtr soft_floor = make_simple_body(ShapeType::plane, dvec3(0), soft_material(4 * kE, 0.02));
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(R), soft_material(kE), 0.003);
  const HydroBodyPtr rigid_ball = make_simple_body(ShapeType::sphere, dvec3(R), {}, 0.003);
  const auto work = [&](const HydroBody& a, const HydroBody& b) {
    constexpr int kSteps = 200;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
      sum += touch(a, b, at_height(R - x * (i + 0.5) / kSteps), Pose{}).wrench.force.z * x / kSteps;
    return sum;
  };
  const double in_floor = work(*rigid_ball, *soft_floor), of_ball = work(*ball, *floor);
  EXPECT_NEAR(energy_at(*rigid_ball, *soft_floor, R - x), in_floor, 2e-3 * in_floor);
  EXPECT_NEAR(energy_at(*ball, *floor, R - x), of_ball, x / R * of_ball);
  const double both = work(*ball, *soft_floor);
  EXPECT_NEAR(energy_at(*ball, *soft_floor, R - x), both, x / R * both);
}

// A thin plate wholly inside: its back face does not count, and its front holds the energy of a thick body.
TEST(ElasticEnergy, IsThatOfAThickBodyForAThinPlate) {
  const HydroBodyPtr soft = make_simple_body(ShapeType::plane, dvec3(0), soft_material(kE, 0.006));
  const HydroBodyPtr plate = make_mesh_body(make_box({0.02, 0.02, 0.0001}), {});
  const double x = 0.001, exact = 0.5 * 0.04 * 0.04 * kE / 0.006 * x * x;
  EXPECT_NEAR(energy_at(*plate, *soft, 0.0001 - x), exact, 1e-9 * exact);
}

}  // namespace
}  // namespace taxel
