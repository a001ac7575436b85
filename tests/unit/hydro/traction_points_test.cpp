// The reduced surface compared with the full one.
#include "core/hydro/traction_points.h"

#include <gtest/gtest.h>

#include "core/hydro/kernel/kernels.h"
#include "core/hydro/quadrature.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

double distance(const Wrench& a, const Wrench& b, double length) {
  return glm::length(a.force - b.force) + glm::length(a.torque - b.torque) / length;
}
double size(const Wrench& w, double length) {
  return distance(w, Wrench{}, length);
}

ContactSurface ball_on_floor(double edge) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(5e4), edge);
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  // Away from the origin, so that moments matter.
  return touch(*ball, *floor, Pose{glm::normalize(dquat(0.9, 0.1, 0.3, -0.2)), {0.1, 0.05, 0.017}}, Pose{}).surface;
}

TEST(SlipFactor, IsTheArcTangentAtAnySpeed) {
  EXPECT_EQ(slip_factor(0), 2 / (kPi * kSlipSpeed));
  long double worst = 0;
  for (double speed = 1e-15; speed < 1e4; speed *= 1.0007) {
    const long double v = speed, exact = 2 / 3.14159265358979323846264338328L *
                                         std::atan(v / static_cast<long double>(kSlipSpeed)) / v;
    worst = std::max(worst, std::abs(static_cast<long double>(slip_factor(speed)) / exact - 1));
  }
  EXPECT_LT(worst, 1e-15L);
}

TEST(PressureMoments, AreTheIntegralsOfEachPolygon) {
  const ContactSurface surface = ball_on_floor(0.003);
  ASSERT_NE(surface.polygons.size() % 8, 0u);  // the last polygons do not fill a group
  std::size_t seen = 0;
  for_each_pressure_moment(surface, [&](const ContactPolygon& polygon, const dvec3& moment) {
    EXPECT_EQ(&polygon, &surface.polygons[seen++]);
    dvec3 sum{0};  // p0 x is of degree 2
    for_each_quadrature_point(surface, polygon, kTriangleDegree4, [&](const dvec3& x, double dA) {
      sum += (polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid)) * dA * x;
    });
    EXPECT_LE(glm::length(moment - sum), 1e-12 * glm::length(sum)) << seen;
  });
  EXPECT_EQ(seen, surface.polygons.size());
}

TEST(TriangleRules, AreExactForTheirDegree) {
  // Integral of u^i v^j over the unit triangle, of area 1/2: i! j! / (i + j + 2)!
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  const auto check = [&](const auto& rule, int degree) {
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; i + j <= degree; ++j) {
        double sum = 0;
        for (const QuadraturePoint& q : rule) sum += 0.5 * q.weight * std::pow(q.u, i) * std::pow(q.v, j);
        EXPECT_NEAR(sum, factorial(i) * factorial(j) / factorial(i + j + 2), 1e-15) << degree << ": " << i << " " << j;
      }
    }
  };
  check(kTriangleDegree2, 2);
  check(kTriangleDegree4, 4);
}

TEST(TractionPoints, GiveThePressureWrenchOfTheSurface) {
  const ContactSurface surface = ball_on_floor(0.003);
  TractionPoints points;
  points.assign(surface);
  points.assign(surface);  // nothing remains of the first surface
  EXPECT_LE(distance(points.pressure_wrench(), pressure_wrench(surface), 0.02),
            1e-14 * size(pressure_wrench(surface), 0.02));
}

TEST(TractionPoints, AreExactForMotionsWithoutRotation) {
  const ContactSurface surface = ball_on_floor(0.003);
  TractionPoints points;
  points.assign(surface);
  for (const double speed : {0.0, 1e-6, 1e-4, 0.1}) {
    const Twist V{speed * dvec3(1, -2, 0.5), dvec3(0)};
    const PairProperties pair{3.0, 0.5};
    const Traction full = traction(surface, pair, V), reduced = points.evaluate(pair, V);
    EXPECT_LE(distance(full.wrench, reduced.wrench, 0.02), 1e-12 * size(full.wrench, 0.02)) << speed;
    EXPECT_LE(distance(full.elastic, reduced.elastic, 0.02), 1e-12 * size(full.elastic, 0.02)) << speed;
  }
}

TEST(TractionPoints, ConvergeForRotationsWithThePolygonSize) {
  const PairProperties pair{3.0, 0.5};
  const Twist V{dvec3(1e-4, 0, 0), dvec3(0.3, -0.2, 0.4)};
  std::vector<double> errors;
  for (const double edge : {0.004, 0.002}) {
    const ContactSurface surface = ball_on_floor(edge);
    TractionPoints points;
    points.assign(surface);
    const Wrench full = traction(surface, pair, V).wrench, elastic = pressure_wrench(surface);
    const Wrench tangential{full.force - elastic.force, full.torque - elastic.torque};
    errors.push_back(distance(points.evaluate(pair, V).wrench, full, 0.02) / size(tangential, 0.02));
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], 0.5 * errors[0]);
}

TEST(TractionPoints, KeepTheExtentOfFewLargePolygons) {
  // The bottom of a soft block has few polygons: rocking must be damped as by the whole face.
  const HydroBodyPtr block = make_mesh_body(make_box({0.03, 0.03, 0.015}), soft_material(2e4, 0.005));
  const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
  const ContactSurface surface = touch(*block, *floor, Pose{{1, 0, 0, 0}, {0, 0, 0.0149}}, Pose{}).surface;
  ASSERT_LT(surface.polygons.size(), 40u);
  TractionPoints points;
  points.assign(surface);
  const PairProperties pair{3.0, 0.5};
  const Twist rocking{dvec3(0), dvec3(0, 1e-3, 0)};
  const Traction full = traction(surface, pair, rocking), reduced = points.evaluate(pair, rocking);
  EXPECT_NEAR(reduced.secant[4][4], full.secant[4][4], 1e-3 * full.secant[4][4]);
}

TEST(TractionPoints, GiveASymmetricSecantAndTheWrench) {
  const ContactSurface surface = ball_on_floor(0.003);
  TractionPoints points;
  points.assign(surface);
  const Twist V{dvec3(2e-4, 1e-4, -0.01), dvec3(0.3, -0.2, 0.4)};
  const Traction t = points.evaluate({3.0, 0.5}, V);
  const std::array<double, 6> v{V.linear.x, V.linear.y, V.linear.z, V.angular.x, V.angular.y, V.angular.z};
  double work = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_EQ(t.secant[i][j], t.secant[j][i]);
      work += v[i] * t.secant[i][j] * v[j];
    }
  }
  EXPECT_GT(work, 0);  // friction and damping dissipate energy
}

TEST(TractionPoints, DoNotPullOnBodiesThatSeparateFast) {
  const ContactSurface surface = ball_on_floor(0.003);
  TractionPoints points;
  points.assign(surface);
  EXPECT_GT(glm::length(points.evaluate({5.0, 0.5}, {}).wrench.force), 0);
  const dvec3 away = glm::normalize(pressure_wrench(surface).force);
  const Wrench w = points.evaluate({5.0, 0.5}, {0.21 * away, dvec3(0)}).wrench;  // faster than 1/d
  EXPECT_EQ(w.force, dvec3(0));
  EXPECT_EQ(w.torque, dvec3(0));
}

}  // namespace
}  // namespace taxel
