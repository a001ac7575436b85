#include "core/layout/field/field_coloring.h"

#include <algorithm>

#include "core/layout/field/field_disc.h"
#include "core/layout/field/point_grid.h"

namespace taxel {
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
