#include "core/hydro/kernel/plane/planar_difference.h"

#include <algorithm>

namespace taxel {
namespace {

std::size_t index_of(int i) {
  return static_cast<std::size_t>(i);
}

void add_vertex(FlatPolygon& polygon, const dvec2& x) {
  if (polygon.count < FlatPolygon::kMax) polygon.x[index_of(polygon.count++)] = x;
}

/// The part of a polygon on the left of the line from a to b.
void keep_left(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left) {
  left.count = 0;
  const dvec2 along = b - a;
  const dvec2* before = &polygon.x[index_of(polygon.count - 1)];
  double side_before = cross_2d(along, *before - a);
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& here = polygon.x[index_of(i)];
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
  for (int i = 1; i + 1 < count; ++i) twice += cross_2d(x[index_of(i)] - x[0], x[index_of(i + 1)] - x[0]);
  return 0.5 * twice;
}

void add_in_parts(const FlatPolygon& polygon, double least_area, std::vector<FlatPolygon>& out) {
  if (polygon.count < 3 || !(polygon.area() > least_area)) return;
  for (int first = 1; first + 1 < polygon.count; first += FlatPolygon::kMaxStored - 2) {
    FlatPolygon& part = out.emplace_back();
    part.count = 0;
    add_vertex(part, polygon.x[0]);
    for (int i = first; i < polygon.count && i <= first + FlatPolygon::kMaxStored - 2; ++i)
      add_vertex(part, polygon.x[index_of(i)]);
  }
}

void split(const FlatPolygon& polygon, const dvec2& a, const dvec2& b, FlatPolygon& left, FlatPolygon& right) {
  left.count = right.count = 0;
  const dvec2 along = b - a;
  dvec2 before = polygon.x[index_of(polygon.count - 1)];
  double side_before = cross_2d(along, before - a);
  bool any_left = false, any_right = false;
  for (int i = 0; i < polygon.count; ++i) {
    const dvec2& here = polygon.x[index_of(i)];
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
    FlatPolygon& next = buffers[index_of(i % 2)];
    keep_left(*inside, b.x[index_of(i)], b.x[index_of((i + 1) % b.count)], next);
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
      split(rest, hole.x[index_of(i)], hole.x[index_of((i + 1) % hole.count)], left, right);
      add_in_parts(right, least_area, scratch);
      rest = left;
    }
  }
  pieces.swap(scratch);
}

}  // namespace taxel
