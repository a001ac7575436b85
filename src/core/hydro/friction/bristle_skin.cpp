#include "core/hydro/friction/bristle_skin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "core/base/error.h"
#include "core/layout/field/point_grid.h"

namespace taxel {
namespace {

struct SkinTriangle {
  dvec3 a{0}, b{0}, c{0};
  double area = 0;
};

std::vector<SkinTriangle> skin_of(const PressureField& field) {
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
  const std::vector<dvec3> pool = pool_of(skin_of(field), kPoolPerRoot * wanted);
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

}  // namespace taxel
