// The region of a plane that the polygons of a pad's tets cover.
#pragma once

#include <cstdint>
#include <vector>

#include "core/hydro/kernel/plane/planar_rest.h"

namespace taxel {

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
