#include "core/hydro/kernel/plane/covered_region.h"

#include <algorithm>
#include <bit>

#include "core/base/index.h"

namespace taxel {
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
