#include "core/layout/flat_map.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

constexpr double kOneSide = 60.0;  // degrees from the mean normal
constexpr double kLeast = 0.8;     // of the typical distance of neighbours
constexpr int kRounds = 400;

/// Median over the taxels of the distance to the nearest other one.
template <class Points>
double typical_distance(const Points& points) {
  std::vector<double> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i) least = std::min(least, glm::distance(points[i], points[j]));
    nearest.push_back(least);
  }
  if (nearest.size() < 2) return 0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

double least_distance(const std::vector<dvec2>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(points[i], points[j]));
  return points.size() < 2 ? 0 : least;
}

/// Pairs that are too close push each other, each by half of what is missing, round by round.
void move_apart(std::vector<dvec2>& points, double least) {
  for (int round = 0; round < kRounds; ++round) {
    std::vector<dvec2> moves(points.size(), dvec2(0));
    bool any = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const dvec2 d = points[i] - points[j];
        const double length = glm::length(d);
        if (!(length < 0.999 * least)) continue;
        any = true;
        const double turn = 2.4 * static_cast<double>(i);  // of those in one place: each its own way
        const dvec2 way = length > 1e-9 * least ? d / length : dvec2(std::cos(turn), std::sin(turn));
        moves[i] += 0.5 * (least - length) * way;
        moves[j] -= 0.5 * (least - length) * way;
      }
    }
    if (!any) return;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += 0.7 * moves[i];
  }
}

dvec3 unit_across(const dvec3& v, const dvec3& axis) {
  const dvec3 across = v - glm::dot(v, axis) * axis;
  return glm::length(across) > 1e-6 * glm::length(v) ? glm::normalize(across) : any_perpendicular(axis);
}

/// Whether all normals lie about their mean, which `mean` gets.
bool one_side(const Layout& layout, dvec3& mean) {
  mean = dvec3(0);
  for (const Taxel& taxel : layout.taxels) mean += glm::normalize(taxel.normal);
  if (!(glm::length(mean) > 0)) return false;
  mean = glm::normalize(mean);
  return std::all_of(layout.taxels.begin(), layout.taxels.end(), [&](const Taxel& taxel) {
    return glm::dot(mean, glm::normalize(taxel.normal)) >= std::cos(kOneSide * kPi / 180);
  });
}

}  // namespace

FlatMap flat_map(const Layout& layout, const dvec3& inside) {
  FlatMap map;
  const dvec3 axis = glm::normalize(layout.frame.distal);
  dvec3 mean;
  map.unrolled = !one_side(layout, mean);
  std::vector<dvec3> centers;
  for (const Taxel& taxel : layout.taxels) {
    const dvec3 p = taxel.center - inside;
    centers.push_back(p);
    if (map.unrolled) {
      // seen from outside with distal up, right is distal x pad turned by the angle about the axis
      const dvec3 pad = unit_across(layout.frame.pad, axis), right = glm::cross(axis, pad);
      const double x = glm::dot(p, right), y = glm::dot(p, pad);
      map.places.emplace_back(std::hypot(x, y) * std::atan2(x, y), glm::dot(p, axis));
    } else {
      const dvec3 up = unit_across(std::abs(glm::dot(axis, mean)) < 0.99 ? axis : -layout.frame.pad, mean);
      map.places.emplace_back(glm::dot(p, glm::cross(up, mean)), glm::dot(p, up));
    }
  }
  move_apart(map.places, kLeast * typical_distance(centers));
  map.apart = least_distance(map.places);
  return map;
}

}  // namespace taxel
