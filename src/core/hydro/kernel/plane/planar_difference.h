// Convex polygons in a plane, and the difference of them.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Returns the area of the parallelogram of two vectors, positive if b is on the left of a.
inline double cross_2d(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// A convex polygon, counter-clockwise.
struct FlatPolygon {
  static constexpr int kMaxStored = 8;  ///< largest number of vertices before a cut
  static constexpr int kMax = 24;       ///< largest number of vertices during a cut
  std::array<dvec2, kMax> x;            // NOLINT: the first `count` entries are the vertices, the others have no value
  int count = 0;

  // Not `= default`: `FlatPolygon{}` would then fill all of `x` with zeros, of which only `count` entries are ever
  // used.
  FlatPolygon() {}  // NOLINT
  FlatPolygon(const FlatPolygon& other) { *this = other; }
  FlatPolygon& operator=(const FlatPolygon& other) {
    if (this == &other) return *this;
    count = other.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) x[i] = other.x[i];
    return *this;
  }
  [[nodiscard]] double area() const;
};

/// Bounds of a polygon of at least one vertex.
struct FlatBox {
  dvec2 lo, hi;
  explicit FlatBox(const FlatPolygon& polygon) : lo(polygon.x[0]), hi(polygon.x[0]) {
    for (std::size_t i = 1; i < static_cast<std::size_t>(polygon.count); ++i) {
      lo = glm::min(lo, polygon.x[i]);
      hi = glm::max(hi, polygon.x[i]);
    }
  }
  [[nodiscard]] bool overlaps(const FlatBox& other) const {
    return lo.x <= other.hi.x && lo.y <= other.hi.y && other.lo.x <= hi.x && other.lo.y <= hi.y;
  }
  /// Returns the larger side.
  [[nodiscard]] double extent() const { return std::max(hi.x - lo.x, hi.y - lo.y); }
};

/// Cuts a polygon along the line from a to b. `left` and `right` become its parts on each side, empty if there is none.
void split(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left, FlatPolygon& right);

/// Returns the area that two convex polygons share.
double shared_area(const FlatPolygon& a, const FlatPolygon& b);

/// Appends a convex polygon in parts of at most FlatPolygon::kMaxStored vertices, unless its area is at most
/// `least_area`.
void add_in_parts(const FlatPolygon& polygon, double least_area, std::vector<FlatPolygon>& out);

/// Replaces each polygon of `pieces` by convex polygons that fill its part outside of `hole`, each of at most
/// FlatPolygon::kMaxStored vertices. Parts of at most `least_area` are dropped. Keeps the memory of `scratch`.
void subtract(const FlatPolygon& hole, double least_area, std::vector<FlatPolygon>& pieces,
              std::vector<FlatPolygon>& scratch);

}  // namespace taxel
