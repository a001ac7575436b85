// The wrench of a contact surface: pressure, Hunt-Crossley damping (1975) and regularised Coulomb friction.
//
// The elastic part is exact: p0 is linear on each polygon, and the moment of p0 x comes from pressure_moments.cpp.
// Damping, a polynomial of degree 3, and friction, which is no polynomial, are summed over quadrature points of degree
// 4.
//
// Both velocity terms have the form -K v with K = beta (I - n n^T) + p0 d n n^T, so the wrench is w_elastic - S V, S =
// integral of J^T K J with J = [I, -[x]]. S is gathered per polygon from the moments 1, x, x x^T of both factors; it is
// symmetric and positive semi-definite, which the implicit step relies on.
//
// Pitfall: the form is exact only while 1 - d vn > 0. Points that separate faster neither push nor rub, so where a
// polygon has such a corner, its elastic wrench is summed over the points that are left. Theory: docs/theory/hydro.md,
// "Traction".
#include "core/hydro/traction.h"

#include <span>

#include "core/hydro/kernel/kernels.h"
#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

std::span<const dvec3> corners_of(const ContactSurface& surface, const ContactPolygon& polygon) {
  return std::span(surface.vertices)
      .subspan(static_cast<std::size_t>(polygon.first), static_cast<std::size_t>(polygon.count));
}

void add_elastic(const ContactPolygon& polygon, const dvec3& moment, Wrench& wrench) {
  wrench.force += polygon.area * polygon.pressure * polygon.normal;
  wrench.torque += glm::cross(moment, polygon.normal);
}

/// Weights 1, x and x x^T summed over points.
struct Moments {
  double sum = 0;
  dvec3 first{0};
  dvec3 diagonal{0}, off_diagonal{0};  ///< xx yy zz, yz zx xy
  void add(double weight, const dvec3& x) {
    const dvec3 wx = weight * x;
    sum += weight;
    first += wx;
    diagonal += wx * x;
    off_diagonal += dvec3(wx.y * x.z, wx.z * x.x, wx.x * x.y);
  }
  [[nodiscard]] dmat3 second() const {
    const dvec3 &d = diagonal, &o = off_diagonal;
    return {dvec3(d.x, o.z, o.y), dvec3(o.z, d.y, o.x), dvec3(o.y, o.x, d.z)};
  }
};

/// Sums of one polygon: at a point x the traction answers the velocity v of A there by -K v dA,
/// K = friction (I - n n^T) + damping n n^T with friction = mu p phi(|vt|), damping = p0 d.
struct PolygonSecant {
  Moments friction, damping;
};

dmat3 cross_matrix(const dvec3& a) {
  return {dvec3(0, a.z, -a.y), dvec3(-a.z, 0, a.x), dvec3(a.y, -a.x, 0)};
}

/// Adds J^T K J, J = [I, -[x]]: K on the velocity of the point x of a body with velocity (v, w) at the origin.
void add_secant(const PolygonSecant& s, const dvec3& n, Matrix6& S) {
  const dmat3 N = cross_matrix(n), beta = s.friction.second(), normal = s.damping.second() - beta;
  const dvec3 first = s.damping.first - s.friction.first;
  const dmat3 linear = s.friction.sum * dmat3(1) + (s.damping.sum - s.friction.sum) * glm::outerProduct(n, n);
  const dmat3 coupling = glm::outerProduct(n, glm::cross(first, n)) - cross_matrix(s.friction.first);
  const double trace = beta[0][0] + beta[1][1] + beta[2][2];
  const dmat3 angular = trace * dmat3(1) - beta + N * normal * glm::transpose(N);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int r = static_cast<int>(i), c = static_cast<int>(j);
      S[i][j] += linear[c][r];
      S[i][j + 3] += coupling[c][r];
      S[j + 3][i] += coupling[c][r];
      S[i + 3][j + 3] += 0.5 * (angular[c][r] + angular[r][c]);
    }
  }
}

/// Returns 1 - d vn of Hunt and Crossley (1975): p = p0 (1 - d vn) if that is positive, and 0 otherwise.
double damping_factor(const dvec3& n, const dvec3& v, const PairProperties& pair) {
  return 1.0 - pair.dissipation * glm::dot(v, n);
}

/// Returns beta = mu p0 (1 - d vn) phi(|vt|) if the damping factor is positive: t = -beta vt [Pa s/m].
double friction_per_speed(double p0, double factor, const dvec3& n, const dvec3& v, const PairProperties& pair) {
  return pair.friction * p0 * factor * slip_factor(glm::length(v - glm::dot(v, n) * n));
}

class Integrator {
 public:
  Integrator(const PairProperties& pair, const Twist& V_BA) : pair_(pair), V_(V_BA) {}

  /// Adds the polygon's elastic wrench and secant; `moment` is the integral of p0 x dA.
  void add(const ContactSurface& surface, const ContactPolygon& polygon, const dvec3& moment, Wrench& elastic,
           Matrix6& secant) const {
    const auto corners = corners_of(surface, polygon);
    const bool pushing = pushes_everywhere(polygon, corners);
    if (pushing) add_elastic(polygon, moment, elastic);
    PolygonSecant sums;
    for_each_quadrature_point(surface, polygon, kTriangleDegree4, [&](const dvec3& x, double dA) {
      add_point(polygon, x, dA, sums, pushing ? nullptr : &elastic);
    });
    add_secant(sums, polygon.normal, secant);
  }

 private:
  [[nodiscard]] dvec3 velocity(const dvec3& x) const { return V_.linear + glm::cross(V_.angular, x); }
  [[nodiscard]] bool pushes_everywhere(const ContactPolygon& polygon, std::span<const dvec3> corners) const {
    return pair_.dissipation == 0 || std::all_of(corners.begin(), corners.end(), [&](const dvec3& x) {
             return damping_factor(polygon.normal, velocity(x), pair_) > 0;
           });
  }

  void add_point(const ContactPolygon& polygon, const dvec3& x, double dA, PolygonSecant& sums, Wrench* elastic) const {
    const dvec3 v = velocity(x), &n = polygon.normal;
    const double p0 = std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid));
    const double factor = damping_factor(n, v, pair_);
    if (!(factor > 0)) return;
    if (pair_.friction > 0) sums.friction.add(friction_per_speed(p0, factor, n, v, pair_) * dA, x);
    if (pair_.dissipation > 0) sums.damping.add(p0 * pair_.dissipation * dA, x);
    if (elastic != nullptr) {
      elastic->force += p0 * dA * n;
      elastic->torque += p0 * dA * glm::cross(x, n);
    }
  }

  const PairProperties& pair_;
  const Twist& V_;
};

}  // namespace

dvec3 friction_traction(double p0, const dvec3& n, const dvec3& v, const PairProperties& pair) {
  const double factor = damping_factor(n, v, pair);
  if (!(factor > 0) || !(p0 > 0) || !(pair.friction > 0)) return dvec3(0);
  return -friction_per_speed(p0, factor, n, v, pair) * (v - glm::dot(v, n) * n);
}

Wrench secant_wrench(const Wrench& elastic, const Matrix6& S, const Twist& V) {
  const std::array<double, 6> velocity{V.linear.x, V.linear.y, V.linear.z, V.angular.x, V.angular.y, V.angular.z};
  std::array<double, 6> answer{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) answer[i] += S[i][j] * velocity[j];
  }
  return {elastic.force - dvec3(answer[0], answer[1], answer[2]),
          elastic.torque - dvec3(answer[3], answer[4], answer[5])};
}

PairProperties combine(const Material& a, const Material& b) {
  PairProperties pair;
  if (a.compliant() && b.compliant()) {
    pair.dissipation = (b.modulus * a.dissipation + a.modulus * b.dissipation) / (a.modulus + b.modulus);
  } else if (a.compliant() || b.compliant()) {
    pair.dissipation = a.compliant() ? a.dissipation : b.dissipation;
  }
  const double sum = a.friction + b.friction;
  pair.friction = sum > 0 ? 2.0 * a.friction * b.friction / sum : 0.0;
  return pair;
}

Traction traction(const ContactSurface& surface, const PairProperties& pair, const Twist& V_BA) {
  Traction result;
  if (pair.dissipation == 0 && pair.friction == 0) {
    result.elastic = pressure_wrench(surface);
    result.wrench = result.elastic;
    return result;
  }
  const Integrator integrator(pair, V_BA);
  for_each_pressure_moment(surface, [&](const ContactPolygon& polygon, const dvec3& moment) {
    integrator.add(surface, polygon, moment, result.elastic, result.secant);
  });
  result.wrench = secant_wrench(result.elastic, result.secant, V_BA);
  return result;
}

Wrench pressure_wrench(const ContactSurface& surface) {
  Wrench wrench;
  for_each_pressure_moment(
      surface, [&](const ContactPolygon& polygon, const dvec3& moment) { add_elastic(polygon, moment, wrench); });
  return wrench;
}

void CenterOfPressure::add(const ContactSurface& surface) {
  for_each_pressure_moment(surface, [&](const ContactPolygon& polygon, const dvec3& moment) {
    moment_ += moment;
    force_ += polygon.area * polygon.pressure;
    area_moment_ += polygon.area * polygon.centroid;
    area_ += polygon.area;
  });
}

void CenterOfPressure::add(const ContactSurface& surface, const Pose& X_WA) {
  CenterOfPressure own;
  own.add(surface);
  moment_ += X_WA.rotate(own.moment_) + own.force_ * X_WA.p;
  force_ += own.force_;
  area_moment_ += X_WA.rotate(own.area_moment_) + own.area_ * X_WA.p;
  area_ += own.area_;
}

std::optional<dvec3> CenterOfPressure::value() const {
  if (force_ > 0) return moment_ / force_;
  if (area_ > 0) return area_moment_ / area_;
  return std::nullopt;
}

dvec3 center_of_pressure(const ContactSurface& surface) {
  CenterOfPressure center;
  center.add(surface);
  return center.value().value_or(dvec3(0));
}

}  // namespace taxel
