#include "core/mesh/formats/polygon_triangles.h"

#include <algorithm>

namespace taxel {
namespace {

constexpr std::size_t kMaxFan = 64;
constexpr std::size_t kMostEars = 4000;  // corners of a polygon that is cut ear by ear
constexpr double kFlat = 1e-10;          // sine of an angle that counts as 0 or 180 degrees

void add_halves(std::span<const int> corners, std::vector<ivec3>& triangles) {
  if (corners.size() < 3) return;
  const std::size_t middle = corners.size() / 2;
  add_halves(corners.subspan(0, middle + 1), triangles);
  triangles.emplace_back(corners.front(), corners[middle], corners.back());
  add_halves(corners.subspan(middle), triangles);
}

void add_fan(std::span<const int> corners, std::vector<ivec3>& triangles) {
  if (corners.size() > kMaxFan) return add_halves(corners, triangles);
  for (std::size_t i = 2; i < corners.size(); ++i) triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
}

/// A polygon seen along its normal.
class FlatPolygon {
 public:
  FlatPolygon(std::span<const dvec3> vertices, std::span<const int> corners)
      : corners_(corners.begin(), corners.end()) {
    dvec3 normal(0);  // Newell's: twice the area along the normal, also of a polygon that is not quite flat
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec3 a = vertices[static_cast<std::size_t>(corners[i])] - vertices[static_cast<std::size_t>(corners[0])];
      const dvec3 b = vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])] -
                      vertices[static_cast<std::size_t>(corners[0])];
      normal += glm::cross(a, b);
    }
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    const dvec3 u = any_perpendicular(normal / length), v = glm::cross(normal / length, u);
    for (const int corner : corners) {
      const dvec3 x = vertices[static_cast<std::size_t>(corner)] - vertices[static_cast<std::size_t>(corners[0])];
      x_.emplace_back(glm::dot(u, x), glm::dot(v, x));
    }
  }

  [[nodiscard]] bool has_area() const { return !x_.empty(); }
  /// Returns true if every corner is convex and none is flat.
  [[nodiscard]] bool is_convex() const {
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (!(turn(i, (i + 1) % x_.size(), (i + 2) % x_.size()) > 0)) return false;
    return true;
  }

  /// Adds all triangles, and those of the rest as a fan if there is no ear left.
  void cut_ears(std::vector<ivec3>& triangles) {
    std::size_t misses = 0, at = 0;
    while (corners_.size() > 3 && misses < corners_.size()) {
      const std::size_t n = corners_.size(), before = (at + n - 1) % n, after = (at + 1) % n;
      if (!is_ear(before, at, after)) {
        ++misses;
        at = after;
        continue;
      }
      triangles.emplace_back(corners_[before], corners_[at], corners_[after]);
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(at));
      x_.erase(x_.begin() + static_cast<std::ptrdiff_t>(at));
      misses = 0;
      at = at == 0 ? corners_.size() - 1 : at - 1;  // only the angles at the two neighbours have changed
    }
    add_fan(corners_, triangles);
  }

 private:
  /// Twice the area of a triangle: positive if it is counterclockwise, 0 if it is flat.
  [[nodiscard]] double turn(std::size_t i, std::size_t j, std::size_t k) const {
    const dvec2 a = x_[j] - x_[i], b = x_[k] - x_[j];
    const double twice = a.x * b.y - a.y * b.x;
    return std::abs(twice) <= kFlat * glm::length(a) * glm::length(b) ? 0 : twice;
  }

  /// Returns true if the corner j is convex and no other corner is in its triangle or on it.
  [[nodiscard]] bool is_ear(std::size_t i, std::size_t j, std::size_t k) const {
    if (!(turn(i, j, k) > 0)) return false;
    for (std::size_t other = 0; other < x_.size(); ++other) {
      if (other == i || other == j || other == k || x_[other] == x_[i] || x_[other] == x_[k]) continue;
      if (turn(i, j, other) >= 0 && turn(j, k, other) >= 0 && turn(k, i, other) >= 0) return false;
    }
    return true;
  }

  std::vector<int> corners_;
  std::vector<dvec2> x_;
};

}  // namespace

void add_polygon_triangles(std::span<const dvec3> vertices, std::span<const int> corners,
                           std::vector<ivec3>& triangles) {
  const auto count = static_cast<int>(vertices.size());
  const bool are_listed = std::all_of(corners.begin(), corners.end(), [&](int corner) { return corner < count; });
  if (are_listed && corners.size() > 3 && corners.size() <= kMostEars) {
    FlatPolygon polygon(vertices, corners);
    if (polygon.has_area() && !polygon.is_convex()) return polygon.cut_ears(triangles);
  }
  add_fan(corners, triangles);
}

}  // namespace taxel
