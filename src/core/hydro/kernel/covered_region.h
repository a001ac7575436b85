// Convex polygons in a plane, their difference, and the region of a plane that the polygons of a pad's tets cover.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
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

// The parts of a polygon in a plane that a region covers or leaves free, found from the edges at which the region ends.

/// An edge at which a region ends. The region is on the left of the way from a to b.
struct RegionEdge {
  dvec2 a, b;
};

/// Replaces an edge by its part inside of a convex polygon. Returns false if no part is inside by more than rounding
/// errors.
bool clip_edge(const FlatPolygon& polygon, RegionEdge& edge);

/// A convex part of a polygon, which a region covers or leaves free as a whole.
struct PlanarPart {
  FlatPolygon polygon;
  bool covered;
};

/// Divides convex polygons by the edges of a region. The memory is kept between calls.
class PlanarRest {
 public:
  /// Divides a convex polygon: the line through an edge divides the polygon and the other edges, and each half is
  /// divided further (binary space partition: Fuchs, Kedem, Naylor 1980). `edges` are inside of the polygon
  /// (clip_edge), and there is at least one. The result is valid until the next call.
  const std::vector<PlanarPart>& divide(const FlatPolygon& polygon, std::span<const RegionEdge> edges);

 private:
  void divide(const FlatPolygon& polygon, std::size_t first, std::size_t last);
  void add_side(const FlatPolygon& polygon, std::size_t first, std::size_t last, bool covered);

  std::vector<RegionEdge> edges_;  ///< edges of the polygon, followed by those of the half that is being divided
  std::vector<PlanarPart> parts_;
  double rounding_ = 0;  ///< distance below which a point is on a line
};

/// Convex polygons in a plane, and the edges at which their union ends. The memory is kept between uses.
///
/// Lists hold the polygons near a piece of the plane. The list of a part of a piece is selected from the list of the
/// piece. Lists are at the end of one array: forget_lists() removes the latest ones.
class CoveredRegion {
 public:
  /// Range of a list.
  struct List {
    std::size_t first = 0, last = 0;
  };

  void clear();
  /// Edges of a polygon at which the region ends: bit k is set for the edge from vertex k to the next one.
  struct Ends {
    std::uint32_t all = 0;
    std::uint32_t at_skin = 0;  ///< those at which the body ends too
  };
  /// Adds a polygon of at most 31 vertices. Polygons must not overlap.
  void add(const FlatPolygon& polygon, const Ends& ends);
  /// Ends the additions, and returns the list of all polygons.
  List list_all();
  /// Returns the list of the polygons of `list` near a piece.
  List list_near(const FlatPolygon& piece, const List& list);
  [[nodiscard]] std::size_t lists_end() const { return lists_.size(); }
  void forget_lists(std::size_t end) { lists_.resize(end); }

  /// The part of a convex piece that the region covers.
  enum class Cover {
    none,
    whole,
    up_to_skin,  ///< the region ends in the piece, and only where the body ends
    part,        ///< the region ends in the piece, also inside of the body
  };
  /// Returns the part of a piece. `near` is the list of the piece.
  [[nodiscard]] Cover cover_of(const FlatPolygon& piece, const List& near) const;
  /// Appends convex polygons that fill the part of a convex piece outside of the region, each of at most
  /// FlatPolygon::kMaxStored vertices. Parts of at most `least_area` are dropped.
  void add_rest(const FlatPolygon& piece, const List& near, double least_area, std::vector<FlatPolygon>& out);

 private:
  struct Polygon {
    FlatPolygon flat;
    FlatBox box;
    Ends ends;
  };
  [[nodiscard]] const Polygon& listed(std::size_t i) const;
  [[nodiscard]] bool contains(const dvec2& x, const List& near) const;
  [[nodiscard]] bool agrees(const std::vector<PlanarPart>& parts, const List& near, double least_area) const;

  std::vector<Polygon> polygons_;
  std::vector<std::int32_t> lists_;
  std::vector<RegionEdge> edges_;
  PlanarRest rest_;
  std::vector<FlatPolygon> pieces_, scratch_;
};

}  // namespace taxel
