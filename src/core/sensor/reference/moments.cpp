// Area and first moments of the part of a polygon inside of a disc, exactly.
//
// By Green's theorem they are sums over the edges, seen from the centre of the disc: where an edge is inside of the
// disc it adds its triangle with the centre, elsewhere the sector between its directions. An edge enters and leaves the
// disc at the roots of a quadratic equation. Sectors turn by less than half a turn each and have a sign, so the sum is
// right whether the centre is inside of the polygon or not, also for clockwise polygons, whose area is negative.
#include "core/sensor/reference/moments.h"

namespace taxel {
namespace {

double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Adds the triangle of the centre, a and b.
void add_triangle(const dvec2& a, const dvec2& b, DiscMoments& sum) {
  const double area = 0.5 * cross(a, b);
  sum.area += area;
  sum.first += area / 3 * (a + b);
}

/// Adds the sector of the disc between the directions of a and b.
void add_sector(const dvec2& a, const dvec2& b, double radius, DiscMoments& sum) {
  const double turn = std::atan2(cross(a, b), glm::dot(a, b)), la = glm::length(a), lb = glm::length(b);
  sum.area += 0.5 * radius * radius * turn;
  if (!(la > 0 && lb > 0)) return;
  const dvec2 from = a / la, to = b / lb;
  sum.first += radius * radius * radius / 3 * dvec2(to.y - from.y, from.x - to.x);
}

/// Adds an edge from a to b, both as offsets from the centre.
void add_edge(const dvec2& a, const dvec2& b, double radius, DiscMoments& sum) {
  const dvec2 along = b - a;
  const double aa = glm::dot(along, along), half = glm::dot(a, along), rest = glm::dot(a, a) - radius * radius;
  const double root = half * half - aa * rest;
  if (!(aa > 0)) return;
  if (!(root > 0)) return add_sector(a, b, radius, sum);
  const double middle = -half / aa, width = std::sqrt(root) / aa;
  const double enter = std::max(0.0, middle - width), leave = std::min(1.0, middle + width);
  if (!(enter < leave)) return add_sector(a, b, radius, sum);
  const dvec2 in = a + enter * along, out = a + leave * along;
  if (enter > 0) add_sector(a, in, radius, sum);
  add_triangle(in, out, sum);
  if (leave < 1) add_sector(out, b, radius, sum);
}

}  // namespace

DiscMoments disc_moments(std::span<const dvec2> polygon, const dvec2& center, double radius) {
  DiscMoments sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    add_edge(polygon[i] - center, polygon[i + 1 < polygon.size() ? i + 1 : 0] - center, radius, sum);
  return sum;
}

}  // namespace taxel
