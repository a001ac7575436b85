// Pairs of taxels that share much of their discs, and colours for fields that overlap.
//
// The part that two discs share is the area of a lens, as if both were in one plane, which is why taxels whose normals
// differ by more than 45 degrees are not compared. Neighbours come from a grid with cells of the middle radius; a pair
// is reported once, with the first earlier taxel. Taxels at one place are left out, since another check names them.
//
// Colours are chosen greedily in the order of the taxels: of the colours that no overlapping earlier field has, the
// first one in turn; if all are taken, the one whose nearest user is farthest away. Cost: about O(n) unless very many
// fields overlap.
#include "core/layout/field/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/layout/field/point_grid.h"
#include "core/layout/field/receptive_field.h"

namespace taxel {
namespace {

constexpr double kMinCosine = std::numbers::sqrt2 / 2;  // cosine of the largest angle between normals that are compared

/// Two discs that share half of the larger one are nearer to each other than the radius of the larger one.
constexpr double kOverlapReach = 1.0;

/// Nearer than this part of the radius, two taxels are the same place written twice, which another check says.
constexpr double kSamePlace = 1e-6;

bool comparable(const Taxel& taxel) {
  return is_finite(taxel.center) && is_finite(taxel.normal) && glm::length(taxel.normal) > 0 && taxel.radius > 0 &&
         std::isfinite(taxel.radius);
}

/// The taxels to compare: well formed, one for each place.
std::vector<std::size_t> places_of(const std::vector<Taxel>& taxels) {
  std::set<std::array<double, 3>> taken;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const dvec3& c = taxels[i].center;
    if (comparable(taxels[i]) && taken.insert({c.x, c.y, c.z}).second) places.push_back(i);
  }
  return places;
}

double middle_radius(const std::vector<Taxel>& taxels, const std::vector<std::size_t>& places) {
  std::vector<double> radii;
  for (const std::size_t i : places) radii.push_back(taxels[i].radius);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

}  // namespace

double disc_overlap(double radius, double other_radius, double distance) {
  const double r = std::min(radius, other_radius), R = std::max(radius, other_radius), d = distance;
  if (d >= r + R) return 0;
  if (d <= R - r) return r * r / (R * R);
  // A = r^2 acos((d^2 + r^2 - R^2) / 2dr) + R^2 acos((d^2 + R^2 - r^2) / 2dR) - sqrt(...) / 2.
  const double of_r = std::clamp((d * d + r * r - R * R) / (2 * d * r), -1.0, 1.0);
  const double of_R = std::clamp((d * d + R * R - r * r) / (2 * d * R), -1.0, 1.0);
  const double kite = (-d + r + R) * (d + r - R) * (d - r + R) * (d + r + R);
  const double area = r * r * std::acos(of_r) + R * R * std::acos(of_R) - 0.5 * std::sqrt(std::max(kite, 0.0));
  return area / (std::numbers::pi * R * R);
}

std::vector<OverlappingTaxels> overlapping_taxels(const std::vector<Taxel>& taxels, double least) {
  const std::vector<std::size_t> places = places_of(taxels);
  if (places.size() < 2) return {};
  std::vector<dvec3> centers;
  for (const std::size_t i : places) centers.push_back(taxels[i].center);
  const PointGrid grid(centers, kOverlapReach * middle_radius(taxels, places));
  std::vector<OverlappingTaxels> found;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Taxel& taxel = taxels[places[k]];
    OverlappingTaxels first{places[k], places[k], 0};
    grid.visit_near(taxel.center, kOverlapReach * taxel.radius, [&](int neighbour) {
      const std::size_t j = places[static_cast<std::size_t>(neighbour)];
      if (j >= first.earlier) return;
      const Taxel& other = taxels[j];
      const double away = glm::distance(taxel.center, other.center);
      const double part = disc_overlap(taxel.radius, other.radius, away);
      if (!(part > least) || away <= kSamePlace * std::max(taxel.radius, other.radius)) return;
      if (glm::dot(glm::normalize(taxel.normal), glm::normalize(other.normal)) < kMinCosine) return;
      first.earlier = j;
      first.part = part;
    });
    if (first.earlier != first.taxel) found.push_back(first);
  }
  return found;
}

namespace {

/// A ball around all discs of a taxel.
struct Ball {
  dvec3 center{0};
  double radius = 0;  ///< [m]
};

Ball ball_around(const Taxel& taxel) {
  Ball ball{taxel.center, 0};
  for (const FieldDisc& disc : discs_of(taxel)) {
    ball.radius = std::max(ball.radius, glm::distance(disc.center, taxel.center) + disc.radius);
  }
  return ball;
}

}  // namespace

std::vector<int> color_fields(const Layout& layout, int colors) {
  constexpr double kNobody = std::numeric_limits<double>::infinity();
  std::vector<Ball> balls;
  std::vector<dvec3> centers;
  double largest = 0;
  for (const Taxel& taxel : layout.taxels) {
    balls.push_back(ball_around(taxel));
    centers.push_back(taxel.center);
    largest = std::max(largest, balls.back().radius);
  }
  const PointGrid grid(centers, largest > 0 ? 2 * largest : 1);
  std::vector<int> color_of(balls.size(), 0);
  std::vector<double> nearest;  // distance of the nearest earlier neighbour with each colour
  for (std::size_t k = 0; k < balls.size(); ++k) {
    nearest.assign(static_cast<std::size_t>(colors), kNobody);
    grid.visit_near(balls[k].center, balls[k].radius + largest, [&](int i) {
      const auto other = static_cast<std::size_t>(i);
      if (other >= k) return;
      const double apart = glm::distance(balls[k].center, balls[other].center);
      double& least = nearest[static_cast<std::size_t>(color_of[other])];
      if (apart < balls[k].radius + balls[other].radius) least = std::min(least, apart);
    });
    auto best = static_cast<std::size_t>(k % static_cast<std::size_t>(colors));
    for (std::size_t step = 1; step < nearest.size() && nearest[best] < kNobody; ++step) {
      const std::size_t next = (k + step) % nearest.size();
      if (nearest[next] > nearest[best]) best = next;
    }
    color_of[k] = static_cast<int>(best);
  }
  return color_of;
}

}  // namespace taxel
