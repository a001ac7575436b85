// A contact surface as points with normals and pushes, for the many evaluations of an implicit step.
//
// A polygon that is a small part of the surface is one point at its centre of pressure, with its exact force; larger
// ones have three or six points in each triangle, so that friction is resolved there too. Points are stored in blocks
// of eight, and traction_sums.cpp sums over blocks. Assigning costs one pass over the polygons; an evaluation then
// depends only on the number of points.
#include "core/hydro/traction_points.h"

#include "core/hydro/kernel/kernels.h"
#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

/// Fractions of the area: a smaller polygon is one point, or three in each triangle.
constexpr double kPoint = 1.0 / 64, kFewPoints = 1.0 / 8;

/// f parts as moments of x, g parts as outer products.
Matrix6 secant(const TractionSums& s) {
  Matrix6 S{};
  std::size_t k = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i; j < 6; ++j) S[i][j] = s.outer[k++];
  const auto &c = s.fx, &d = s.fxx, &o = s.fxy;
  for (std::size_t i = 0; i < 3; ++i) S[i][i] += s.f;
  // -[c] above the diagonal blocks; |x|^2 I - x x^T in the angular one
  S[0][4] += c[2], S[0][5] -= c[1], S[1][3] -= c[2], S[1][5] += c[0], S[2][3] += c[1], S[2][4] -= c[0];
  S[3][3] += d[1] + d[2], S[4][4] += d[2] + d[0], S[5][5] += d[0] + d[1];
  S[3][4] -= o[2], S[3][5] -= o[1], S[4][5] -= o[0];
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j) S[i][j] = S[j][i];
  return S;
}

}  // namespace

void TractionPoints::assign(const ContactSurface& surface) {
  blocks_.clear();
  count_ = 0;
  pressure_wrench_ = {};
  const double area = surface.area();
  for_each_pressure_moment(surface, [&](const ContactPolygon& polygon, const dvec3& moment) {
    const double push = polygon.area * polygon.pressure;
    if (!(push > 0)) return;
    pressure_wrench_.force += push * polygon.normal;
    pressure_wrench_.torque += glm::cross(moment, polygon.normal);
    const auto add_point = [&](const dvec3& x, double dA) {
      const double p0 = polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
      if (p0 > 0) add(x, polygon.normal, p0 * dA);
    };
    if (polygon.area <= kPoint * area) {
      add(moment / push, polygon.normal, push);
    } else if (polygon.area <= kFewPoints * area) {
      for_each_quadrature_point(surface, polygon, kTriangleDegree2, add_point);
    } else {
      for_each_quadrature_point(surface, polygon, kTriangleDegree4, add_point);
    }
  });
}

void TractionPoints::add(const dvec3& x, const dvec3& n, double push) {
  const std::size_t lane = count_++ % TractionBlock::kPoints;
  if (lane == 0) blocks_.emplace_back();  // zeros
  TractionBlock& block = blocks_.back();
  const dvec3 m = glm::cross(x, n);
  for (int axis = 0; axis < 3; ++axis) {
    block.x[axis][lane] = x[axis];
    block.n[axis][lane] = n[axis];
    block.m[axis][lane] = m[axis];
  }
  block.push[lane] = push;
}

Traction TractionPoints::evaluate(const PairProperties& pair, const Twist& V_BA) const {
  const TractionSums sums = sum_traction(blocks_, pair, V_BA);
  Traction result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.elastic.force[static_cast<int>(i)] = sums.force[i];
    result.elastic.torque[static_cast<int>(i)] = sums.torque[i];
  }
  result.secant = secant(sums);
  result.wrench = secant_wrench(result.elastic, result.secant, V_BA);
  return result;
}

}  // namespace taxel
