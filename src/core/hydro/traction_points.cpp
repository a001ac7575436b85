#include "core/hydro/traction_points.h"

#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

constexpr double kManyPolygons = 64;  // a polygon below this part of the surface counts as a point

/// Symmetric sums over points of J^T K J, J = [I, -[x]], K = f I + g n n^T:
/// f parts as moments of x, g parts as u u^T, u = J^T n = (n, x x n).
class SecantSum {
 public:
  void add(const dvec3& x, const dvec3& n, double f, double g) {
    f_ += f;
    const dvec3 fx = f * x;
    first_ += fx;
    diagonal_ += fx * x;
    off_diagonal_ += dvec3(fx.y * x.z, fx.z * x.x, fx.x * x.y);
    const dvec3 m = glm::cross(x, n);
    const std::array<double, 6> u{n.x, n.y, n.z, m.x, m.y, m.z};
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j) outer_[k++] += g * u[i] * u[j];
  }

  [[nodiscard]] Matrix6 matrix() const {
    Matrix6 S{};
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j) S[i][j] = outer_[k++];
    const dvec3 &c = first_, &d = diagonal_, &o = off_diagonal_;
    for (std::size_t i = 0; i < 3; ++i) S[i][i] += f_;
    // -[c] above the diagonal blocks; |x|^2 I - x x^T in the angular one
    S[0][4] += c.z, S[0][5] -= c.y, S[1][3] -= c.z, S[1][5] += c.x, S[2][3] += c.y, S[2][4] -= c.x;
    S[3][3] += d.y + d.z, S[4][4] += d.z + d.x, S[5][5] += d.x + d.y;
    S[3][4] -= o.z, S[3][5] -= o.y, S[4][5] -= o.x;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < i; ++j) S[i][j] = S[j][i];
    return S;
  }

 private:
  double f_ = 0;
  dvec3 first_{0}, diagonal_{0}, off_diagonal_{0};
  std::array<double, 21> outer_{};
};

}  // namespace

void TractionPoints::assign(const ContactSurface& surface) {
  points_.clear();
  const double large = surface.area() / kManyPolygons;
  for (const ContactPolygon& polygon : surface.polygons) {
    if (polygon.area > large) {
      add_quadrature(surface, polygon);
      continue;
    }
    const double push = polygon.area * polygon.pressure;
    if (push > 0) points_.push_back({pressure_moment(surface, polygon) / push, polygon.normal, push});
  }
}

/// A polygon that makes up much of the surface: its fan's triangles by a rule that is exact for p0 x and p0 x x^T.
void TractionPoints::add_quadrature(const ContactSurface& surface, const ContactPolygon& polygon) {
  const dvec3* corners = surface.vertices.data() + polygon.first;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const double area =
        0.5 * glm::dot(glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]), polygon.normal);
    for (const QuadraturePoint& q : kTriangleDegree4) {
      const dvec3 x = q.u * corners[0] + q.v * corners[i] + (1 - q.u - q.v) * corners[i + 1];
      const double p0 = polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
      const double push = p0 * q.weight * area;
      if (push > 0) points_.push_back({x, polygon.normal, push});
    }
  }
}

Traction TractionPoints::evaluate(const PairProperties& pair, const Twist& V_BA) const {
  Traction result;
  SecantSum sum;
  for (const Point& point : points_) {
    const dvec3 &x = point.x, &n = point.normal;
    const dvec3 v = V_BA.linear + glm::cross(V_BA.angular, x);
    const double vn = glm::dot(v, n);
    const double factor = 1.0 - pair.dissipation * vn;  // Hunt and Crossley (1975)
    if (!(factor > 0)) continue;
    const dvec3 force = point.push * n;
    result.elastic.force += force;
    result.elastic.torque += glm::cross(x, force);
    const double friction = pair.friction * point.push * factor * slip_factor(glm::length(v - vn * n));
    sum.add(x, n, friction, point.push * pair.dissipation - friction);
  }
  result.secant = sum.matrix();
  const std::array<double, 6> V{V_BA.linear.x,  V_BA.linear.y,  V_BA.linear.z,
                                V_BA.angular.x, V_BA.angular.y, V_BA.angular.z};
  result.wrench = result.elastic;
  for (int i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      result.wrench.force[i] -= result.secant[static_cast<std::size_t>(i)][j] * V[j];
      result.wrench.torque[i] -= result.secant[static_cast<std::size_t>(i) + 3][j] * V[j];
    }
  }
  return result;
}

}  // namespace taxel
