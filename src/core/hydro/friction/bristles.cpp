#include "core/hydro/friction/bristles.h"

#include <algorithm>
#include <cmath>

#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

dvec3 tangential(const dvec3& v, const dvec3& n) {
  return v - glm::dot(v, n) * n;
}

/// Returns the factor (1 - d vn)+ of Hunt and Crossley (1975).
double push_factor(const Bristle& b, const BristleLaw& law, const dvec3& v) {
  return std::max(0.0, 1 - law.pair.dissipation * glm::dot(v, b.normal));
}

/// The deflection that makes the force of a bristle, and the force per deflection.
struct Bend {
  dvec3 u{0};
  double beta = 0;
  bool slips = false;
};
Bend bend_of(const Bristle& b, const BristleLaw& law, const dvec3& v) {
  Bend bend{b.u + (law.timestep + law.time) * tangential(v, b.normal), law.stiffness * b.area, false};
  const double limit = law.pair.friction * b.push * push_factor(b, law, v), length = glm::length(bend.u);
  if (bend.beta * length > limit) bend = {bend.u, limit / length, true};
  return bend;
}

dvec3 velocity_at(const dvec3& x, const Twist& V) {
  return V.linear + glm::cross(V.angular, x);
}

/// Calls f(x, area) for the parts of a triangle, which is bisected across its longest edge until that is at most
/// `edge`.
template <class F>
void divide(const dvec3& a, const dvec3& b, const dvec3& c, double area, double edge, int depth, const F& f) {
  const double ab = glm::length(b - a), bc = glm::length(c - b), ca = glm::length(a - c);
  const double longest = std::max({ab, bc, ca});
  if (depth == 0 || longest <= edge) {
    f((a + b + c) / 3.0, area);
  } else if (ab == longest) {
    divide(a, 0.5 * (a + b), c, 0.5 * area, edge, depth - 1, f);
    divide(0.5 * (a + b), b, c, 0.5 * area, edge, depth - 1, f);
  } else if (bc == longest) {
    divide(b, 0.5 * (b + c), a, 0.5 * area, edge, depth - 1, f);
    divide(0.5 * (b + c), c, a, 0.5 * area, edge, depth - 1, f);
  } else {
    divide(c, 0.5 * (c + a), b, 0.5 * area, edge, depth - 1, f);
    divide(0.5 * (c + a), a, b, 0.5 * area, edge, depth - 1, f);
  }
}

/// Returns true if the polygon fits into a circle of this diameter about its centroid.
bool is_small(const ContactSurface& surface, const ContactPolygon& polygon, double diameter) {
  for (int i = polygon.first; i < polygon.first + polygon.count; ++i)
    if (glm::length(surface.vertices[static_cast<std::size_t>(i)] - polygon.centroid) > 0.5 * diameter) return false;
  return true;
}

/// The sum of J^T K J over points, J = [I, -[x]], K = f (I - n n^T).
class TangentSecant {
 public:
  void add(const dvec3& x, const dvec3& n, double f) {
    const dvec3 fx = f * x, m = glm::cross(x, n);
    sum_ += f;
    first_ += fx;
    diagonal_ += fx * x;
    off_diagonal_ += dvec3(fx.y * x.z, fx.z * x.x, fx.x * x.y);
    const std::array<double, 6> row{n.x, n.y, n.z, m.x, m.y, m.z};
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j) outer_[k++] += f * row[i] * row[j];
  }
  void add_to(Matrix6& S) const {
    Matrix6 T{};
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j) T[i][j] = -outer_[k++];
    const dvec3 &c = first_, &d = diagonal_, &o = off_diagonal_;
    for (std::size_t i = 0; i < 3; ++i) T[i][i] += sum_;
    // -[c] in the upper block, |x|^2 I - x x^T in the angular one
    T[0][4] += c.z, T[0][5] -= c.y, T[1][3] -= c.z, T[1][5] += c.x, T[2][3] += c.y, T[2][4] -= c.x;
    T[3][3] += d.y + d.z, T[4][4] += d.z + d.x, T[5][5] += d.x + d.y;
    T[3][4] -= o.z, T[3][5] -= o.y, T[4][5] -= o.x;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) S[i][j] += i <= j ? T[i][j] : T[j][i];
  }

 private:
  double sum_ = 0;
  dvec3 first_{0}, diagonal_{0}, off_diagonal_{0};  // xx yy zz, yz zx xy
  std::array<double, 21> outer_{};                  // upper triangle by rows
};

}  // namespace

BristleAnswer answer_of(const Bristle& b, const BristleLaw& law, const Twist& V_BA) {
  const dvec3 v = velocity_at(b.x, V_BA), vt = tangential(v, b.normal);
  const Bend bend = bend_of(b, law, v);
  BristleAnswer answer{-bend.beta * bend.u, b.u, bend.slips};
  const double elastic = law.stiffness * b.area;
  if (!bend.slips || !(elastic > 0)) return answer;
  // The element gives a force k (u1 + T (u1 - u)/h) that equals the limited one, with the deflection u1 at the end.
  const dvec3 limited = (bend.beta / elastic) * bend.u;
  const double ratio = law.timestep > 0 ? law.time / law.timestep : 0;
  answer.u = (limited + ratio * b.u) / (1 + ratio) - law.timestep * vt;
  return answer;
}

void BristleContact::assign(const ContactSurface& surface, BristleSearch& search) {
  constexpr int kBisections = 12;
  const BristleSkin& skin = search.skin();
  bristles_.clear();
  place_.assign(skin.roots().size(), -1);
  const double edge = skin.spacing();
  for (const ContactPolygon& polygon : surface.polygons) {
    if (is_small(surface, polygon, edge)) {
      add(polygon.centroid, polygon.area, polygon.area * polygon.pressure, polygon.normal, search);
      continue;
    }
    for_each_triangle(surface, polygon, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
      divide(a, b, c, area, edge, kBisections, [&](const dvec3& x, double dA) {
        const double p0 = polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid);
        add(x, dA, std::max(0.0, p0) * dA, polygon.normal, search);
      });
    });
  }
  for (Bristle& b : bristles_) {  // x is the sum of push times place so far, normal that of push times normal
    const dvec3& root = skin.roots()[static_cast<std::size_t>(b.root)];
    b.normal = glm::normalize(b.normal);
    b.x = root + glm::dot(b.x / b.push - root, b.normal) * b.normal;
  }
}

void BristleContact::add(const dvec3& x, double area, double push, const dvec3& normal, BristleSearch& search) {
  if (!(push > 0)) return;
  for (const BristleShare& share : search.shares(x)) {
    int& place = place_[static_cast<std::size_t>(share.root)];
    if (place < 0) {
      place = static_cast<int>(bristles_.size());
      bristles_.push_back({share.root});
    }
    Bristle& b = bristles_[static_cast<std::size_t>(place)];
    b.area += share.part * area;
    b.push += share.part * push;
    b.normal += share.part * push * normal;
    b.x += share.part * push * x;
  }
}

void BristleContact::add_friction(const BristleLaw& law, const Twist& V_BA, Traction& sum) const {
  TangentSecant secant;
  for (const Bristle& b : bristles_) {
    const Bend bend = bend_of(b, law, velocity_at(b.x, V_BA));
    const dvec3 force = -bend.beta * b.u;
    sum.elastic.force += force;
    sum.elastic.torque += glm::cross(b.x, force);
    secant.add(b.x, b.normal, bend.beta * (law.timestep + law.time));
  }
  secant.add_to(sum.secant);
  sum.wrench = secant_wrench(sum.elastic, sum.secant, V_BA);
}

}  // namespace taxel
