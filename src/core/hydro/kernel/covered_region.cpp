// A convex piece of a plane minus the convex polygons of a pad's tets, as convex polygons.
//
// Subtracting one polygon after the other would cut the piece along every edge of every polygon. But most edges are
// shared by two polygons, and only the edges at which the region ends matter: those on a face of a tet without a
// neighbour (CoveredRegion::Ends). The line through the longest of them divides the piece and the other edges, and each
// half is divided further (binary space partition: Fuchs, Kedem, Naylor 1980). A part without an edge inside is covered
// or free as a whole, as the side of its last edge says.
//
// Pitfalls. Tets that overlap, or touch without a common edge, have edges that are no ends of the region, whose sides
// say nothing. So the middle of each part must agree with a search among the polygons; if one does not, each polygon is
// subtracted along all of its edges. Distances below 1e-9 of the piece count as on a line. The polygons near a piece
// are selected from the list of the piece that it was cut from.
#include "core/hydro/kernel/covered_region.h"

#include <algorithm>
#include <bit>

#include "core/base/math.h"

namespace taxel {
namespace {

void add_vertex(FlatPolygon& polygon, const dvec2& x) {
  if (polygon.count < FlatPolygon::kMax) polygon.x[at(polygon.count++)] = x;
}

/// The part of a polygon on the left of the line from a to b.
void keep_left(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left) {
  left.count = 0;
  const dvec2 along = b - a;
  const dvec2* before = &polygon.x[at(polygon.count - 1)];
  double side_before = cross_2d(along, *before - a);
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& here = polygon.x[at(i)];
    const double side = cross_2d(along, here - a);
    if ((side > 0 && side_before < 0) || (side < 0 && side_before > 0))
      add_vertex(left, *before + (side_before / (side_before - side)) * (here - *before));
    if (side >= 0) add_vertex(left, here);
    before = &here;
    side_before = side;
  }
}

}  // namespace

double FlatPolygon::area() const {
  double twice = 0;
  for (int i = 1; i + 1 < count; ++i) twice += cross_2d(x[at(i)] - x[0], x[at(i + 1)] - x[0]);
  return 0.5 * twice;
}

void add_in_parts(const FlatPolygon& polygon, double least_area, std::vector<FlatPolygon>& out) {
  if (polygon.count < 3 || !(polygon.area() > least_area)) return;
  for (int first = 1; first + 1 < polygon.count; first += FlatPolygon::kMaxStored - 2) {
    FlatPolygon& part = out.emplace_back();
    part.count = 0;
    add_vertex(part, polygon.x[0]);
    for (int i = first; i < polygon.count && i <= first + FlatPolygon::kMaxStored - 2; ++i)
      add_vertex(part, polygon.x[at(i)]);
  }
}

void split(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left, FlatPolygon& right) {
  left.count = right.count = 0;
  const dvec2 along = b - a;
  dvec2 before = polygon.x[at(polygon.count - 1)];
  double side_before = cross_2d(along, before - a);
  bool any_left = false, any_right = false;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& here = polygon.x[at(i)];
    const double side = cross_2d(along, here - a);
    if ((side > 0 && side_before < 0) || (side < 0 && side_before > 0)) {
      const dvec2 crossing = before + (side_before / (side_before - side)) * (here - before);
      add_vertex(left, crossing);
      add_vertex(right, crossing);
    }
    if (side >= 0) add_vertex(left, here);
    if (side <= 0) add_vertex(right, here);
    any_left = any_left || side > 0;
    any_right = any_right || side < 0;
    before = here;
    side_before = side;
  }
  if (!any_left) left.count = 0;
  if (!any_right) right.count = 0;
}

double shared_area(const FlatPolygon& a, const FlatPolygon& b) {
  std::array<FlatPolygon, 2> buffers;
  const FlatPolygon* inside = &a;
  for (int i = 0; i < b.count && inside->count >= 3; ++i) {
    FlatPolygon& next = buffers[at(i % 2)];
    keep_left(*inside, b.x[at(i)], b.x[at((i + 1) % b.count)], next);
    inside = &next;
  }
  return inside->count >= 3 ? inside->area() : 0.0;
}

void subtract(const FlatPolygon& hole, double least_area, std::vector<FlatPolygon>& pieces,
              std::vector<FlatPolygon>& scratch) {
  const FlatBox hole_box(hole);
  const auto is_near = [&](const FlatPolygon& piece) { return hole_box.overlaps(FlatBox(piece)); };
  if (std::none_of(pieces.begin(), pieces.end(), is_near)) return;
  scratch.clear();
  FlatPolygon left, right;
  for (const FlatPolygon& piece : pieces) {
    if (!is_near(piece) || !(shared_area(piece, hole) > least_area)) {
      scratch.push_back(piece);
      continue;
    }
    FlatPolygon rest = piece;
    for (int i = 0; i < hole.count && rest.count >= 3; ++i) {
      split(rest, hole.x[at(i)], hole.x[at((i + 1) % hole.count)], left, right);
      add_in_parts(right, least_area, scratch);
      rest = left;
    }
  }
  pieces.swap(scratch);
}

namespace {

/// Distance below which a point is on a line, as a fraction of the extent of the polygon.
constexpr double kOnLine = 1e-9;

double rounding_in(const FlatPolygon& polygon) {
  return kOnLine * FlatBox(polygon).extent();
}

std::size_t longest_of(std::span<const RegionEdge> edges) {
  std::size_t found = 0;
  double most = -1;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const dvec2 along = edges[i].b - edges[i].a;
    const double squared = glm::dot(along, along);
    if (squared > most) most = squared, found = i;
  }
  return found;
}

}  // namespace

bool clip_edge(const FlatPolygon& polygon, RegionEdge& edge) {
  const double rounding = rounding_in(polygon);
  double begin = 0, end = 1;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& corner = polygon.x[at(i)];
    const dvec2 side = polygon.x[at(i + 1 < polygon.count ? i + 1 : 0)] - corner;
    const double a = cross_2d(side, edge.a - corner), b = cross_2d(side, edge.b - corner);
    if (std::max(a, b) <= rounding * glm::length(side)) return false;
    if (a < 0) begin = std::max(begin, a / (a - b));
    if (b < 0) end = std::min(end, a / (a - b));
  }
  const dvec2 along = edge.b - edge.a;
  if (!((end - begin) * glm::length(along) > rounding)) return false;
  edge = {edge.a + begin * along, edge.a + end * along};
  return true;
}

const std::vector<PlanarPart>& PlanarRest::divide(const FlatPolygon& polygon, std::span<const RegionEdge> edges) {
  parts_.clear();
  edges_.assign(edges.begin(), edges.end());
  rounding_ = rounding_in(polygon);
  divide(polygon, 0, edges_.size());
  return parts_;
}

void PlanarRest::divide(const FlatPolygon& polygon, std::size_t first, std::size_t last) {
  const std::size_t chosen = first + longest_of({edges_.data() + first, last - first});
  const RegionEdge line = edges_[chosen];
  const dvec2 along = line.b - line.a;
  const double rounding = rounding_ * glm::length(along);
  FlatPolygon left, right;
  split(polygon, line.a, line.b, left, right);
  for (const double side : {1.0, -1.0}) {
    const std::size_t begin = edges_.size();
    for (std::size_t i = first; i < last; ++i) {
      if (i == chosen) continue;
      const RegionEdge edge = edges_[i];
      const double a = side * cross_2d(along, edge.a - line.a), b = side * cross_2d(along, edge.b - line.a);
      if (std::max(a, b) <= rounding) continue;
      const dvec2 crossing = edge.a + a / (a - b) * (edge.b - edge.a);
      edges_.push_back({a < -rounding ? crossing : edge.a, b < -rounding ? crossing : edge.b});
    }
    add_side(side > 0 ? left : right, begin, edges_.size(), side > 0);
    edges_.resize(begin);
  }
}

void PlanarRest::add_side(const FlatPolygon& polygon, std::size_t first, std::size_t last, bool covered) {
  if (polygon.count < 3) return;
  if (first < last) {
    divide(polygon, first, last);
  } else {
    parts_.push_back({polygon, covered});
  }
}

namespace {

/// Distance outside of a polygon at which a point is still in it, as a fraction of the polygon's extent: a point
/// between two polygons is in both of them.
constexpr double kNearly = 1e-10;

/// Returns a point inside of a convex polygon that is not a sliver.
dvec2 middle_of(const FlatPolygon& polygon) {
  dvec2 sum(0);
  for (int i = 0; i < polygon.count; ++i) sum += polygon.x[at(i)];
  return sum / static_cast<double>(polygon.count);
}

const dvec2& corner_after(const FlatPolygon& polygon, int i) {
  return polygon.x[at(i + 1 < polygon.count ? i + 1 : 0)];
}

/// Returns true if a convex polygon contains a point, or nearly.
bool holds(const FlatPolygon& polygon, const dvec2& x, double extent) {
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2 side = corner_after(polygon, i) - polygon.x[at(i)];
    if (cross_2d(side, x - polygon.x[at(i)]) < -kNearly * extent * extent) return false;
  }
  return true;
}

/// Calls f with each end of the region at a polygon, and whether it is at the skin, until f returns false.
template <class Polygon, class F>
bool each_end(const Polygon& polygon, const F& f) {
  for (std::uint32_t ends = polygon.ends.all; ends != 0; ends &= ends - 1) {
    const int k = std::countr_zero(ends);
    const bool at_skin = (polygon.ends.at_skin >> k & 1u) != 0;
    if (!f(RegionEdge{polygon.flat.x[at(k)], corner_after(polygon.flat, k)}, at_skin)) return false;
  }
  return true;
}

}  // namespace

const CoveredRegion::Polygon& CoveredRegion::listed(std::size_t i) const {
  return polygons_[at(lists_[i])];
}

void CoveredRegion::clear() {
  polygons_.clear();
  lists_.clear();
}

void CoveredRegion::add(const FlatPolygon& polygon, const Ends& ends) {
  if (polygon.count >= 3) polygons_.push_back({polygon, FlatBox(polygon), ends});
}

CoveredRegion::List CoveredRegion::list_all() {
  lists_.clear();
  for (std::size_t i = 0; i < polygons_.size(); ++i) lists_.push_back(static_cast<std::int32_t>(i));
  return {0, lists_.size()};
}

CoveredRegion::List CoveredRegion::list_near(const FlatPolygon& piece, const List& list) {
  const FlatBox box(piece);
  const std::size_t first = lists_.size();
  for (std::size_t i = list.first; i < list.last; ++i)
    if (listed(i).box.overlaps(box)) lists_.push_back(lists_[i]);
  return {first, lists_.size()};
}

bool CoveredRegion::contains(const dvec2& x, const List& near) const {
  for (std::size_t i = near.first; i < near.last; ++i) {
    const auto& [flat, box, ends] = listed(i);
    const double nearly = kNearly * box.extent();
    const bool in_box = glm::all(glm::lessThanEqual(glm::abs(2.0 * x - box.lo - box.hi), box.hi - box.lo + nearly));
    if (in_box && holds(flat, x, box.extent())) return true;
  }
  return false;
}

CoveredRegion::Cover CoveredRegion::cover_of(const FlatPolygon& piece, const List& near) const {
  bool ends_at_skin = false;
  for (std::size_t i = near.first; i < near.last; ++i) {
    const bool goes_on = each_end(listed(i), [&](RegionEdge edge, bool at_skin) {
      if ((at_skin && ends_at_skin) || !clip_edge(piece, edge)) return true;
      ends_at_skin = at_skin;
      return at_skin;
    });
    if (!goes_on) return Cover::part;
  }
  if (ends_at_skin) return Cover::up_to_skin;
  return contains(middle_of(piece), near) ? Cover::whole : Cover::none;
}

void CoveredRegion::add_rest(const FlatPolygon& piece, const List& near, double least_area,
                             std::vector<FlatPolygon>& out) {
  edges_.clear();
  for (std::size_t i = near.first; i < near.last; ++i) {
    each_end(listed(i), [&](RegionEdge edge, bool) {
      if (clip_edge(piece, edge)) edges_.push_back(edge);
      return true;
    });
  }
  if (edges_.empty()) {
    if (contains(middle_of(piece), near)) return;
  } else {
    const std::vector<PlanarPart>& parts = rest_.divide(piece, edges_);
    if (agrees(parts, near, least_area)) {
      for (const PlanarPart& part : parts)
        if (!part.covered) add_in_parts(part.polygon, least_area, out);
      return;
    }
  }
  // The piece is free, or its middle is in a gap between two polygons that have lost a sliver. Or edges are not ends of
  // the region, because polygons overlap or touch without an edge in common.
  pieces_.assign(1, piece);
  for (std::size_t i = near.first; i < near.last && !pieces_.empty(); ++i)
    subtract(listed(i).flat, least_area, pieces_, scratch_);
  out.insert(out.end(), pieces_.begin(), pieces_.end());
}

bool CoveredRegion::agrees(const std::vector<PlanarPart>& parts, const List& near, double least_area) const {
  constexpr double kSmall = 1e-5;  // of the piece: a part whose wrong place nobody notices
  double area = 0;
  for (const PlanarPart& part : parts) area += part.polygon.area();
  return std::all_of(parts.begin(), parts.end(), [&](const PlanarPart& part) {
    return part.polygon.area() <= std::max(least_area, kSmall * area) ||
           part.covered == contains(middle_of(part.polygon), near);
  });
}

}  // namespace taxel
