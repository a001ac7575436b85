// Wrenches of contact surfaces against closed forms of damping and friction.
#include "core/hydro/traction.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

using Vector6 = std::array<double, 6>;

Vector6 as_array(const dvec3& a, const dvec3& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}

/// Returns a surface of a ball in a box's edge: polygons of all sizes, curved pressure, two normals.
ContactSurface curved_surface() {
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(0.02, 0, 0), soft_material(1e5), 0.006);
  const auto box = make_simple_body(ShapeType::box, dvec3(0.02));
  return touch(*ball, *box, Pose{}, {glm::normalize(dquat(0.92, 0.3, 0.1, 0.2)), dvec3(0.012, 0.01, -0.03)}).surface;
}

/// Returns a surface of a box on a slab: 1200 mm^2 under p = 2e4 Pa, pushed along +z: N = 24 N.
ContactSurface flat_surface() {
  const auto slab = make_slab({0.02, 0.015}, 0.01, {3, 2, 2}, 2e7);
  const auto box = make_simple_body(ShapeType::box, dvec3(0.1));
  return touch(*box, *slab, Pose{}, at_height(-0.099)).surface;
}
constexpr double kForce = 24;

Twist random_twist(int i, double speed) {
  const CounterRng rng(77, static_cast<std::uint64_t>(i));
  const auto r = [&](std::uint64_t k) { return speed * (2 * rng.uniform(k) - 1); };
  return {{r(0), r(1), r(2)}, {50 * r(3), 50 * r(4), 50 * r(5)}};
}

/// Returns the integral in the definition of the header, by many points on each polygon.
Wrench by_definition(const ContactSurface& s, const PairProperties& pair, const Twist& V) {
  constexpr int kCuts = 12;
  Wrench sum;
  for (const ContactPolygon& polygon : s.polygons) {
    for (int k = 1; k + 1 < polygon.count; ++k) {
      const dvec3& a = s.vertices[static_cast<std::size_t>(polygon.first)];
      const dvec3 ab = (s.vertices[static_cast<std::size_t>(polygon.first + k)] - a) / double(kCuts);
      const dvec3 ac = (s.vertices[static_cast<std::size_t>(polygon.first + k + 1)] - a) / double(kCuts);
      const double dA = 0.5 * glm::length(glm::cross(ab, ac));
      for (int i = 0; i < kCuts; ++i) {
        for (int j = 0; j < 2 * (kCuts - i) - 1; ++j) {
          const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
          const dvec3 x = a + (i + third) * ab + (j / 2 + third) * ac, &n = polygon.normal;
          const dvec3 v = V.linear + glm::cross(V.angular, x), vt = v - glm::dot(v, n) * n;
          const double p0 = polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
          const double p = p0 * std::max(0.0, 1 - pair.dissipation * glm::dot(v, n)), slip = glm::length(vt);
          dvec3 t{0};
          if (slip > 0) t = -2 / kPi * pair.friction * p * std::atan(slip / kSlipSpeed) * vt / slip;
          sum.force += dA * (p * n + t);
          sum.torque += dA * glm::cross(x, p * n + t);
        }
      }
    }
  }
  return sum;
}

TEST(Traction, EqualsItsDefinition) {
  const ContactSurface s = curved_surface();
  ASSERT_GT(s.polygons.size(), 20u);
  const double scale = glm::length(pressure_wrench(s).force);
  for (int i = 0; i < 30; ++i) {
    const Twist V = random_twist(i, i < 10 ? 1e-4 : 0.05);
    const PairProperties pair{i % 3 * 1.5, i % 2 * 0.8};
    const Wrench found = traction(s, pair, V).wrench, expected = by_definition(s, pair, V);
    // Slow motion: smooth over each polygon. Fast motion: the rotation centre is inside a polygon, where friction
    // changes its sign.
    const double tolerance = (i < 10 ? 2e-4 : 1.5e-3) * scale;
    EXPECT_LE(glm::distance(found.force, expected.force), tolerance) << i;
    EXPECT_LE(glm::distance(found.torque, expected.torque), tolerance * 0.02) << i;
  }
}

TEST(Traction, GivesTheElasticWrenchLessSecantTimesVelocity) {
  const ContactSurface s = curved_surface();
  for (int i = 0; i < 30; ++i) {
    const Twist V = random_twist(i, 0.01);
    const Traction t = traction(s, {1.0, 0.5}, V);
    const Vector6 v = as_array(V.linear, V.angular), elastic = as_array(t.elastic.force, t.elastic.torque);
    const Vector6 wrench = as_array(t.wrench.force, t.wrench.torque);
    for (std::size_t r = 0; r < 6; ++r) {
      double expected = elastic[r];
      for (std::size_t c = 0; c < 6; ++c) expected -= t.secant[r][c] * v[c];
      EXPECT_NEAR(wrench[r], expected, 1e-12 * glm::length(t.elastic.force));
    }
  }
}

/// Returns the smallest eigenvalue relative to the largest, by Jacobi rotations (1846).
double definiteness(Matrix6 S) {
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 6; ++p) {
      for (std::size_t q = p + 1; q < 6; ++q) {
        if (S[p][q] == 0) continue;
        const double theta = 0.5 * std::atan2(2 * S[p][q], S[q][q] - S[p][p]), c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < 6; ++k) {
          const double a = S[k][p], b = S[k][q];
          S[k][p] = c * a - s * b;
          S[k][q] = s * a + c * b;
        }
        for (std::size_t k = 0; k < 6; ++k) {
          const double a = S[p][k], b = S[q][k];
          S[p][k] = c * a - s * b;
          S[q][k] = s * a + c * b;
        }
      }
    }
  }
  double least = S[0][0], most = S[0][0];
  for (std::size_t i = 1; i < 6; ++i) {
    least = std::min(least, S[i][i]);
    most = std::max(most, S[i][i]);
  }
  return least / most;
}

TEST(Traction, HasASymmetricSecantThatAddsNoEnergy) {
  for (const ContactSurface& s : {curved_surface(), flat_surface()}) {
    for (int i = 0; i < 40; ++i) {
      const Matrix6 S = traction(s, {i % 2 * 2.0, i % 3 * 0.4 + 0.1}, random_twist(i, i < 20 ? 1e-4 : 1.0)).secant;
      for (std::size_t r = 0; r < 6; ++r) {
        for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(S[r][c], S[c][r]);
      }
      EXPECT_GE(definiteness(S), -1e-14) << i;
    }
  }
}

TEST(Traction, IsThePressureAloneAtRest) {
  const ContactSurface s = curved_surface();
  const Wrench pressure = pressure_wrench(s);
  const Traction t = traction(s, {2.0, 0.7}, {});
  EXPECT_EQ(t.wrench.force, pressure.force);
  EXPECT_EQ(t.wrench.torque, pressure.torque);
  EXPECT_EQ(traction(s, {}, random_twist(1, 1)).wrench.force, pressure.force);
}

TEST(Traction, GivesASlidingBlockMuTimesItsLoad) {
  const ContactSurface s = flat_surface();
  EXPECT_NEAR(pressure_wrench(s).force.z, kForce, 1e-11 * kForce);
  constexpr double mu = 0.6;
  for (const double speed : {1e-6, 1e-4, 1e-2, 1.0, 1e4}) {
    const Wrench w = traction(s, {0, mu}, {{0.6 * speed, -0.8 * speed, 0}, dvec3(0)}).wrench;
    const double expected = mu * kForce * 2 / kPi * std::atan(speed / kSlipSpeed);
    EXPECT_NEAR(w.force.x, -0.6 * expected, 1e-12 * expected);
    EXPECT_NEAR(w.force.y, 0.8 * expected, 1e-12 * expected);
    EXPECT_NEAR(w.force.z, kForce, 1e-11 * kForce);
  }
  EXPECT_NEAR(glm::length(dvec2(traction(s, {0, mu}, {{1e4, 0, 0}, dvec3(0)}).wrench.force)), mu * kForce, 1e-6);
}

TEST(Traction, FollowsHuntAndCrossleyInDamping) {
  const ContactSurface s = flat_surface();
  constexpr double d = 3;
  for (const double vn : {-2.0, -0.1, 0.0, 0.1, 0.3, 0.333, 0.4, 10.0}) {
    const Traction t = traction(s, {d, 0}, {{0, 0, vn}, dvec3(0)});
    EXPECT_NEAR(t.wrench.force.z, kForce * std::max(0.0, 1 - d * vn), 1e-11 * kForce) << vn;  // never adhesive
    EXPECT_NEAR(t.elastic.force.z, vn < 1 / d ? kForce : 0, 1e-11 * kForce) << vn;
  }
}

TEST(Traction, IsExactForTheDampingOfATumblingBody) {
  // Linear pressure times linear speed times lever has degree 3, which is exact. Here p is uniform and vn = w x r.
  const ContactSurface s = flat_surface();
  constexpr double d = 1, w = 5, p = 2e4, a = 0.02, b = 0.015;
  const Wrench found = traction(s, {d, 0}, {dvec3(0), {0, w, 0}}).wrench;  // vn = -w x
  EXPECT_NEAR(found.force.z, kForce, 1e-11 * kForce);
  EXPECT_NEAR(found.torque.y, -p * d * w * 4 * a * a * a * b / 3, 1e-11 * kForce * a);
}

TEST(Traction, HasTheExactCentroidOfPressure) {
  // A wedge of pressure: a plane tilted about y through the slab; p = k (depth), zero at x = -a.
  constexpr double a = 0.02, b = 0.015, slope = 0.1;
  const auto slab = make_slab({a, b}, 0.01, {5, 3, 2}, 2e7);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  const Pose X_WP{glm::angleAxis(std::atan(slope), dvec3(0, 1, 0)) * dquat(0, 1, 0, 0), dvec3(-a, 0, 0)};
  const ContactSurface s = touch(*slab, *plane, Pose{}, X_WP).surface;
  const dvec3 c = center_of_pressure(s);
  EXPECT_NEAR(c.x, a / 3, 1e-12);  // two thirds of the way
  EXPECT_NEAR(c.y, 0, 1e-12);
  EXPECT_NEAR(c.z, -slope * (c.x + a), 1e-12);
  const Wrench w = pressure_wrench(s);
  EXPECT_LE(glm::distance(w.torque, glm::cross(c, w.force)), 1e-12 * glm::length(w.force));
  EXPECT_EQ(center_of_pressure(ContactSurface{}), dvec3(0));
}

TEST(Traction, HasOneCentreOfPressureForSurfacesWithPoses) {
  const ContactSurface s = flat_surface();
  const dvec3 own = center_of_pressure(s);
  const Pose X_WA{glm::angleAxis(0.4, glm::normalize(dvec3(1, 2, -1))), dvec3(0.3, -0.1, 0.2)};
  CenterOfPressure sum;
  EXPECT_FALSE(sum.value());
  sum.add(s, X_WA);
  EXPECT_LT(glm::distance(*sum.value(), X_WA * own), 1e-15);
  sum.add(s, X_WA);
  sum.add(s);  // a third of the force
  EXPECT_LT(glm::distance(*sum.value(), (2.0 * (X_WA * own) + own) / 3.0), 1e-15);
}

TEST(Combine, FollowsTheRulesOfMixtures) {
  Material a = soft_material(1e5), b = soft_material(3e5), rigid;
  a.dissipation = 2;
  b.dissipation = 1;
  rigid.dissipation = 9;
  a.friction = 0.5;
  b.friction = 1.0;
  EXPECT_NEAR(combine(a, b).dissipation, (3e5 * 2 + 1e5 * 1) / 4e5, 1e-15);
  EXPECT_NEAR(combine(a, b).friction, 2 * 0.5 / 1.5, 1e-15);
  EXPECT_EQ(combine(a, rigid).dissipation, 2);
  EXPECT_EQ(combine(rigid, a).dissipation, 2);
  a.friction = b.friction = 0;
  EXPECT_EQ(combine(a, b).friction, 0);
}

}  // namespace
}  // namespace taxel
