// Roots of bristles, their shares of a contact, and the friction of a contact of bristles. The law of one bristle is in
// bristles.h.
//
// 1. Roots are farthest points (Gonzalez 1985) among six times as many candidates, one in each of as many parts of
//    equal area of the skin. n choices take time in proportion to n log n by a grid.
// 2. Each point of a contact surface shares its area and load among the roots that are nearly as near as the nearest
//    one, by weights that are continuous in its place. If each polygon belonged to its nearest root, the force would
//    jump whenever a sliding contact moves a polygon from one root to the next. Large polygons are divided until their
//    parts are no longer than the spacing of the roots.
// 3. A bristle answers a twist with -beta e, e = u + (h + T) vt, with beta = k A below the Coulomb limit and limit/|e|
//    above. This is a secant: linear in the velocity, with a beta that falls as |e| grows, so the implicit step solves
//    it with the same iteration as viscous friction.
//
// Pitfalls: roots of a cell of the search are candidates for all of its points, so cells never change a share. The root
// is moved along the mean normal into the contact surface, so that its torque is that of the surface. Theory:
// docs/theory/hydro.md, "Friction that sticks".
#include "core/hydro/bristles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "core/base/error.h"
#include "core/hydro/quadrature.h"
#include "core/layout/field/point_grid.h"

namespace taxel {
namespace {

struct SkinTriangle {
  dvec3 a{0}, b{0}, c{0};
  double area = 0;
};

std::vector<SkinTriangle> skin_triangles(const PressureField& field) {
  std::vector<SkinTriangle> skin;
  for (const Tet& tet : field.tets()) {
    for (int corner = 0; corner < 4; ++corner) {
      if (!field.is_skin(tet, corner)) continue;
      std::array<dvec3, 3> v;
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != corner) v[static_cast<std::size_t>(k++)] = field.vertices()[static_cast<std::size_t>(tet.vertices[i])];
      skin.push_back({v[0], v[1], v[2], 0.5 * glm::length(glm::cross(v[1] - v[0], v[2] - v[0]))});
    }
  }
  return skin;
}

/// Returns `count` points of the skin, one in each of as many parts of equal area. Places within a triangle are those
/// of a sequence of low discrepancy (Roberts 2018), folded into the triangle.
std::vector<dvec3> pool_of(const std::vector<SkinTriangle>& skin, std::size_t count) {
  double total = 0;
  for (const SkinTriangle& t : skin) total += t.area;
  std::vector<dvec3> pool;
  pool.reserve(count);
  double passed = 0;
  for (const SkinTriangle& t : skin) {
    passed += t.area;
    while (pool.size() < count &&
           (static_cast<double>(pool.size()) + 0.5) * total < passed * static_cast<double>(count)) {
      const double n = static_cast<double>(pool.size() + 1);
      double u = n * 0.7548776662466927, v = n * 0.5698402909980532;
      u -= std::floor(u);
      v -= std::floor(v);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      pool.push_back(t.a + u * (t.b - t.a) + v * (t.c - t.a));
    }
  }
  return pool;
}

double squared_distance(const dvec3& a, const dvec3& b) {
  return glm::dot(a - b, a - b);
}

/// Farthest-point sampling (Gonzalez 1985): each choice is the point with the largest distance from the points chosen
/// before, the first of those in the pool. A choice shortens the distances only of points that are nearer to it than
/// the largest distance. They are found in a grid whose cells shrink with that distance, so that n choices take time in
/// proportion to n log n.
class FarthestPoints {
 public:
  explicit FarthestPoints(const std::vector<dvec3>& pool)
      : pool_(pool), squared_(pool.size(), std::numeric_limits<double>::infinity()) {}

  void choose(std::size_t chosen) {
    const auto shorten = [&](std::size_t i) {
      squared_[i] = std::min(squared_[i], squared_distance(pool_[i], pool_[chosen]));
    };
    if (open_.empty()) {
      for (std::size_t i = 0; i < pool_.size(); ++i) shorten(i), open_.push({squared_[i], i});
    } else if (farthest().squared > 0) {
      const double reach = (1 + kRounding) * std::sqrt(farthest().squared);
      if (!grid_ || reach < 0.5 * cell_) grid_.emplace(pool_, cell_ = reach);
      grid_->visit_near(pool_[chosen], reach, [&](int i) { shorten(static_cast<std::size_t>(i)); });
    }
    while (open_.top().squared != squared_[open_.top().point]) {  // its distance has become shorter
      const std::size_t point = open_.top().point;
      open_.pop();
      open_.push({squared_[point], point});
    }
  }

  struct Farthest {
    double squared = 0;
    std::size_t point = 0;
    bool operator<(const Farthest& other) const {
      return squared < other.squared || (squared == other.squared && point > other.point);
    }
  };
  /// Returns the point of the next choice, and its squared distance from the nearest chosen one.
  [[nodiscard]] const Farthest& farthest() const { return open_.top(); }

 private:
  static constexpr double kRounding = 1e-9;

  const std::vector<dvec3>& pool_;
  std::vector<double> squared_;         // squared distance of each point from the nearest chosen one
  std::priority_queue<Farthest> open_;  // each point once, with a distance that it has or had
  std::optional<PointGrid> grid_;
  double cell_ = 0;  // edge of the grid's cells
};

}  // namespace

BristleSkin::BristleSkin(const PressureField& field, int count) {
  constexpr std::size_t kPoolPerRoot = 6;
  if (count < 1) throw Error(fmt::format("the number of bristles must be at least 1, is {}", count));
  const auto wanted = static_cast<std::size_t>(count);
  const std::vector<dvec3> pool = pool_of(skin_triangles(field), kPoolPerRoot * wanted);
  if (pool.size() < wanted) throw Error("the pressure field has no skin for bristles");
  FarthestPoints spread(pool);
  roots_.reserve(wanted);
  for (std::size_t next = 0; roots_.size() < wanted; next = spread.farthest().point) {
    roots_.push_back(pool[next]);
    spread.choose(next);
  }
  spacing_ = std::sqrt(spread.farthest().squared);
  if (!(spacing_ > 0)) spacing_ = field.size();
}

const std::vector<int>& BristleSearch::candidates(const dvec3& x) {
  const double edge = skin_->spacing();  // also an upper bound of s
  const dvec3 cell = glm::floor(x / edge), center = (cell + 0.5) * edge;
  std::uint64_t key = 0;
  for (int i = 0; i < 3; ++i)
    key = (key << 21U) | (static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[i])) & 0x1fffffU);
  const auto [place, is_new] = cells_.try_emplace(key);
  if (!is_new) return place->second;
  const double radius = 0.5 * std::sqrt(3.0) * edge;
  double least = std::numeric_limits<double>::infinity();
  for (const dvec3& root : skin_->roots()) least = std::min(least, squared_distance(root, center));
  const double reach = std::sqrt((std::sqrt(least) + radius) * (std::sqrt(least) + radius) + edge * edge) + radius;
  for (std::size_t i = 0; i < skin_->roots().size(); ++i)
    if (squared_distance(skin_->roots()[i], center) <= reach * reach) place->second.push_back(static_cast<int>(i));
  return place->second;
}

std::span<const BristleShare> BristleSearch::shares(const dvec3& x) {
  shares_.clear();
  double least = std::numeric_limits<double>::infinity();
  for (const int root : candidates(x)) {
    const double squared = squared_distance(skin_->roots()[static_cast<std::size_t>(root)], x);
    shares_.push_back({root, squared});
    least = std::min(least, squared);
  }
  double sum = 0;
  std::size_t kept = 0;
  for (const BristleShare& share : shares_) {
    const double part = share_of(share.part, least, skin_->reach());
    if (!(part > 0)) continue;
    shares_[kept++] = {share.root, part};
    sum += part;
  }
  shares_.resize(kept);
  for (BristleShare& share : shares_) share.part /= sum;
  return shares_;
}

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

namespace {

/// Returns the mean of a value of the roots at a point by their shares, or `none` if there are no roots.
template <class T, class Value>
T mean_at(const StickingFriction& friction, const dvec3& x, const T& none, const Value& value) {
  double least = std::numeric_limits<double>::infinity();
  for (const StickingFriction::Root& root : friction.roots) least = std::min(least, squared_distance(root.place, x));
  T sum = none;
  double parts = 0;
  for (const StickingFriction::Root& root : friction.roots) {
    const double part = share_of(squared_distance(root.place, x), least, friction.reach);
    sum += part * value(root);
    parts += part;
  }
  return parts > 0 ? sum / parts : none;
}

}  // namespace

dvec3 StickingFriction::traction_at(const dvec3& x) const {
  return mean_at(*this, x, dvec3(0), [](const Root& root) { return root.traction; });
}

double StickingFriction::slip_at(const dvec3& x) const {
  return mean_at(*this, x, 0.0, [](const Root& root) { return root.slips ? 1.0 : 0.0; });
}

StickingFriction sticking_friction(const BristleContact& contact, const BristleSkin& skin, const BristleLaw& law,
                                   const Twist& V_BA) {
  StickingFriction friction;
  friction.reach = skin.reach();
  for (const Bristle& b : contact.bristles()) {
    const BristleAnswer answer = answer_of(b, law, V_BA);
    friction.roots.push_back(
        {skin.roots()[static_cast<std::size_t>(b.root)], b.normal, b.area, answer.force / b.area, answer.slips});
  }
  return friction;
}

StickingFriction mirrored(const StickingFriction& on_A, const RigidTransform& X_BA) {
  StickingFriction on_B = on_A;
  for (StickingFriction::Root& root : on_B.roots)
    root = {X_BA(root.place), -(X_BA.R * root.normal), root.area, -(X_BA.R * root.traction), root.slips};
  return on_B;
}

}  // namespace taxel
