#include "core/hydro/kernel/plane/planar_rest.h"

#include <algorithm>

#include "core/base/index.h"

namespace taxel {
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

}  // namespace taxel
