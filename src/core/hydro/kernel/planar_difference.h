// Convex polygons in a plane, and the difference of them.
#pragma once

#include <array>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// A convex polygon, counter-clockwise.
struct FlatPolygon {
  static constexpr int kMaxStored = 8;  ///< vertices of a polygon that cutting is given
  static constexpr int kMax = 24;       ///< vertices of one while it is cut
  std::array<dvec2, kMax> x;            // NOLINT: filled up to `count`
  int count = 0;

  FlatPolygon() {}  // NOLINT: `x` holds what it did
  FlatPolygon(const FlatPolygon& other) { *this = other; }
  FlatPolygon& operator=(const FlatPolygon& other) {
    if (this == &other) return *this;
    count = other.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) x[i] = other.x[i];
    return *this;
  }
  [[nodiscard]] double area() const;
};

/// Cuts a polygon along the line from a to b. `left` and `right` get what lies on each side; empty if nothing does.
void split(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left, FlatPolygon& right);

/// The area that two convex polygons share.
double shared_area(const FlatPolygon& a, const FlatPolygon& b);

/// Replaces each polygon of `pieces` by convex polygons that fill what `hole` leaves of it, none with more than
/// FlatPolygon::kMaxStored vertices. Parts of at most `least_area` are dropped. Keeps the memory of `scratch`.
void subtract(const FlatPolygon& hole, double least_area, std::vector<FlatPolygon>& pieces,
              std::vector<FlatPolygon>& scratch);

}  // namespace taxel
