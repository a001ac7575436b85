// The parts of a polygon in a plane that a region covers or leaves free, found from the edges at which the region ends.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/kernel/plane/planar_difference.h"

namespace taxel {

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

}  // namespace taxel
