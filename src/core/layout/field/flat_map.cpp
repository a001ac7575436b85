// The places of the taxels on a flat map of the sensor.
//
// If all normals are less than 60 degrees from their mean, the map is the view along this mean. Otherwise the sensor is
// unrolled about the axis along `distal`: arc length at the taxel's own distance from the axis to the right, height up.
// A projection may bring taxels together that are apart on the sensor, so pairs that are nearer than 0.9 of the typical
// distance push each other apart, each by half of the missing distance, for at most 400 rounds; a grid finds the pairs.
// Taxels at one place move in directions that depend on their numbers, so the map is the same each time.
#include "core/layout/field/flat_map.h"

#include <algorithm>
#include <cmath>

#include "core/layout/field/point_grid.h"

namespace taxel {
namespace {

constexpr double kOneSide = 60.0;  // degrees from the mean normal
constexpr double kMin = 0.9;       // of the typical distance of neighbours
constexpr int kRounds = 400;
constexpr std::size_t kMaxAsked = 500;

/// Median over the taxels, or some of many, of the distance to the nearest other one.
double typical_distance(const std::vector<dvec3>& points) {
  std::vector<double> nearest;
  const std::size_t stride = 1 + points.size() / kMaxAsked;
  for (std::size_t i = 0; i < points.size(); i += stride) {
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

/// Calls visit(i, j) for j < i of points that lie within `reach` of each other.
template <class Visit>
void visit_pairs(const std::vector<dvec2>& points, double reach, const Visit& visit) {
  std::vector<dvec3> flat;
  for (const dvec2& p : points) flat.emplace_back(p, 0);
  const PointGrid grid(flat, reach);
  for (std::size_t i = 0; i < points.size(); ++i)
    grid.visit_near(flat[i], reach, [&](int j) {
      if (static_cast<std::size_t>(j) < i) visit(i, static_cast<std::size_t>(j));
    });
}

/// Returns the smallest distance of two points, at most `reach`.
double least_distance(const std::vector<dvec2>& points, double reach) {
  double least = reach;
  visit_pairs(points, reach,
              [&](std::size_t i, std::size_t j) { least = std::min(least, glm::distance(points[i], points[j])); });
  return least;
}

/// Pairs that are too close push each other apart, each by half of the missing distance, round by round.
void move_apart(std::vector<dvec2>& points, double least) {
  for (int round = 0; round < kRounds; ++round) {
    std::vector<dvec2> moves(points.size(), dvec2(0));
    bool any = false;
    visit_pairs(points, least, [&](std::size_t i, std::size_t j) {
      const dvec2 d = points[i] - points[j];
      const double length = glm::length(d);
      if (!(length < 0.999 * least)) return;
      any = true;
      const double turn = 2.4 * static_cast<double>(i);  // angle, different for each of the points at one place
      const dvec2 way = length > 1e-9 * least ? d / length : dvec2(std::cos(turn), std::sin(turn));
      moves[i] += 0.5 * (least - length) * way;
      moves[j] -= 0.5 * (least - length) * way;
    });
    if (!any) return;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += 0.7 * moves[i];
  }
}

dvec3 unit_across(const dvec3& v, const dvec3& axis) {
  const dvec3 across = v - glm::dot(v, axis) * axis;
  return glm::length(across) > 1e-6 * glm::length(v) ? glm::normalize(across) : any_perpendicular(axis);
}

/// Returns true if all normals lie about their mean, which `mean` gets.
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
      // Seen from outside with distal up, right is distal x pad turned by the angle about the axis
      const dvec3 pad = unit_across(layout.frame.pad, axis), right = glm::cross(axis, pad);
      const double x = glm::dot(p, right), y = glm::dot(p, pad);
      map.places.emplace_back(std::hypot(x, y) * std::atan2(x, y), glm::dot(p, axis));
    } else {
      const dvec3 up = unit_across(std::abs(glm::dot(axis, mean)) < 0.99 ? axis : -layout.frame.pad, mean);
      map.places.emplace_back(glm::dot(p, glm::cross(up, mean)), glm::dot(p, up));
    }
  }
  const double typical = typical_distance(centers);
  if (!(typical > 0)) return map;
  move_apart(map.places, kMin * typical);
  map.apart = least_distance(map.places, 2 * typical);
  return map;
}

}  // namespace taxel
