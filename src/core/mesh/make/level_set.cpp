// The surface on which a signed distance function is zero, by marching tetrahedra (Doi, Koide 1991).
//
// The box is divided into cubes and each cube into six tets about its diagonal, so neighbouring cubes divide their
// common face alike. A tet with corners on both sides gets one or two triangles with vertices on its edges, shared by
// all tets at the edge. Unlike marching cubes there is no ambiguous case, and the surface is closed.
//
// A vertex is placed linearly, or exactly by regula falsi (Illinois form, Dowell and Jarratt 1971). It stays a small
// part of the edge away from the nodes, so that no triangle loses its area. Cost: one value per node, and about five
// per vertex for exact zeros. Pitfall: a function that is negative at the rim of the box, or no number, is refused, or
// the surface would be open.
#include "core/mesh/make/level_set.h"

#include <fmt/format.h>

#include <array>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/math.h"

namespace taxel {
namespace {

/// The six tets of a unit cube around its main diagonal: each is a path of one step along each axis.
constexpr std::array<std::array<int, 3>, 6> kAxisOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

class LevelSet {
 public:
  LevelSet(const std::function<double(const dvec3&)>& distance, const Aabb& box, double edge, EdgeZero zero)
      : distance_(distance), zero_(zero) {
    const dvec3 extent = box.extent(), cells = extent / edge + 3.0;
    const double most = std::max({extent.x, extent.y, extent.z});
    constexpr double kMostNodes = 1.5e8;
    if (!(edge > 0) || !(most > 0) || !(cells.x * cells.y * cells.z <= kMostNodes))
      throw Error(fmt::format("an edge of {} m cannot be for a body of {} m", edge, most));
    step_ = edge;
    for (int a = 0; a < 3; ++a) cells_[a] = static_cast<int>(std::ceil(extent[a] / step_)) + 2;
    origin_ = box.center() - 0.5 * step_ * dvec3(cells_);
    sample();
  }

  TriMesh mesh() {
    for (int z = 0; z < cells_.z; ++z) {
      for (int y = 0; y < cells_.y; ++y) {
        for (int x = 0; x < cells_.x; ++x) cut_cube({x, y, z});
      }
    }
    return {std::move(vertices_), std::move(faces_)};
  }

 private:
  [[nodiscard]] int number(const ivec3& n) const { return (n.z * (cells_.y + 1) + n.y) * (cells_.x + 1) + n.x; }
  [[nodiscard]] dvec3 position(const ivec3& n) const { return origin_ + step_ * dvec3(n); }
  [[nodiscard]] bool inside(const ivec3& n) const { return values_[at(number(n))] < 0; }

  double value(const dvec3& x) const {
    const double d = distance_(x);
    if (!std::isfinite(d))
      throw Error(fmt::format("its distance function is {} at ({:.6g}, {:.6g}, {:.6g})", d, x.x, x.y, x.z));
    return d;
  }

  void sample() {
    for (int z = 0; z <= cells_.z; ++z) {
      for (int y = 0; y <= cells_.y; ++y) {
        for (int x = 0; x <= cells_.x; ++x) {
          const ivec3 n(x, y, z);
          values_.push_back(value(position(n)));
          const bool rim = glm::any(glm::equal(n, ivec3(0))) || glm::any(glm::equal(n, cells_));
          if (rim && inside(n)) {
            const dvec3 p = position(n);
            throw Error(
                fmt::format("its distance function is negative at ({:.6g}, {:.6g}, {:.6g}), outside of its "
                            "bounding box",
                            p.x, p.y, p.z));
          }
        }
      }
    }
  }

  /// Returns the vertex on the edge between two nodes of the grid, of which one is inside.
  int vertex(ivec3 a, ivec3 b) {
    if (number(b) < number(a)) std::swap(a, b);
    const ivec3 d = b - a;
    const long long key = 8LL * number(a) + d.x + 2 * d.y + 4 * d.z;
    const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<int>(vertices_.size()));
    if (fresh) vertices_.push_back(zero_ == EdgeZero::exact ? zero_between(a, b) : linear_zero(a, b));
    return entry->second;
  }

  [[nodiscard]] dvec3 linear_zero(const ivec3& a, const ivec3& b) const {
    constexpr double kLeast = 0.02;
    const double at_a = values_[at(number(a))], at_b = values_[at(number(b))];
    return position(a) + std::clamp(at_a / (at_a - at_b), kLeast, 1 - kLeast) * (position(b) - position(a));
  }

  /// Regula falsi in its Illinois form (Dowell, Jarratt 1971), bracketing.
  dvec3 zero_between(const ivec3& a, const ivec3& b) const {
    constexpr int kMaxRounds = 60;  // edges nearly tangent to the surface need many, others about 5
    constexpr double kLeast = 1e-3, kNear = 1e-9;
    const dvec3 p = position(a), q = position(b);
    double lo = 0, hi = 1, at_lo = values_[at(number(a))], at_hi = values_[at(number(b))], t = 0;
    int kept = 0;  // end that was kept in the last round: 1 for lo, -1 for hi
    for (int i = 0; i < kMaxRounds; ++i) {
      t = (lo * at_hi - hi * at_lo) / (at_hi - at_lo);
      const double now = value(p + t * (q - p));
      if (std::abs(now) <= kNear * step_) break;
      if ((now < 0) == (at_hi < 0)) {
        hi = t;
        at_hi = now;
        if (kept == 1) at_lo *= 0.5;
        kept = 1;
      } else {
        lo = t;
        at_lo = now;
        if (kept == -1) at_hi *= 0.5;
        kept = -1;
      }
    }
    return p + std::clamp(t, kLeast, 1 - kLeast) * (q - p);
  }

  void cut_cube(const ivec3& low) {
    int count = 0;
    for (int i = 0; i < 8; ++i) count += inside(low + ivec3(i & 1, i >> 1 & 1, i >> 2)) ? 1 : 0;
    if (count == 0 || count == 8) return;
    for (std::size_t k = 0; k < kAxisOrders.size(); ++k) {
      std::array<ivec3, 4> tet{low, low, low, low};
      for (int i = 0; i < 3; ++i) {
        for (int j = i + 1; j < 4; ++j) ++tet[at(j)][kAxisOrders[k][at(i)]];
      }
      if (k >= 3) std::swap(tet[2], tet[3]);  // odd permutations have the opposite orientation
      cut_tet(tet);
    }
  }

  /// Sorts corners inside to the front by an even permutation, so that triangles face from inside to outside.
  void cut_tet(std::array<ivec3, 4> tet) {
    int count = 0, swaps = 0;
    for (int i = 0; i < 4; ++i) {
      if (!inside(tet[at(i)])) continue;
      if (i != count) {
        std::swap(tet[at(i)], tet[at(count)]);
        ++swaps;
      }
      ++count;
    }
    if (count == 0 || count == 4) return;
    if (swaps % 2 == 1) std::swap(tet[count == 3 ? 0 : 2], tet[count == 3 ? 1 : 3]);
    const auto on = [&](std::size_t i, std::size_t j) { return vertex(tet[i], tet[j]); };
    if (count == 1) {
      faces_.emplace_back(on(0, 1), on(0, 2), on(0, 3));
    } else if (count == 3) {
      faces_.emplace_back(on(3, 0), on(3, 1), on(3, 2));
    } else {
      const int a = on(0, 2), b = on(0, 3), c = on(1, 3), d = on(1, 2);
      faces_.emplace_back(a, b, c);
      faces_.emplace_back(a, c, d);
    }
  }

  const std::function<double(const dvec3&)>& distance_;
  EdgeZero zero_;
  ivec3 cells_{0};
  dvec3 origin_{0};
  double step_ = 0;
  std::vector<double> values_;
  std::unordered_map<long long, int> numbers_;
  std::vector<dvec3> vertices_;
  std::vector<ivec3> faces_;
};

}  // namespace

TriMesh make_level_set(const std::function<double(const dvec3&)>& distance, const Aabb& box, double edge,
                       EdgeZero zero) {
  return LevelSet(distance, box, edge, zero).mesh();
}

}  // namespace taxel
