// The view along rays of a tet: what it promises about where they pass, against the rays themselves.
#include "core/sensor/ray_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace taxel {
namespace {

dvec3 random_vector(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0.0, size);
  return {normal(random), normal(random), normal(random)};
}

/// Rays through a place about `size` wide, a metre at most from the origin, whose directions differ by about `spread`.
struct Bundle {
  std::vector<SensorRay> rays;
  std::vector<RayPiece> pieces;

  Bundle(std::mt19937& random, double size, double spread) {
    const dvec3 at = random_vector(random, 0.3), along = glm::normalize(random_vector(random, 1.0));
    std::uniform_real_distribution<double> part(0.0, size);
    rays.resize(13);
    for (SensorRay& ray : rays) {
      ray.origin = at + random_vector(random, size);
      ray.direction = glm::normalize(along + random_vector(random, spread));
      ray.max_depth = 10 * size;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const double start = part(random);
      pieces.push_back({&rays[i], static_cast<std::int32_t>(i), start, start + part(random)});
    }
  }
};

dvec3 in_view(const RayView& view, const dvec3& p) {
  dvec3 seen(0);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    seen[i] = view.x[k] * p.x + view.y[k] * p.y + view.z[k] * p.z;
  }
  return seen;  // depth, u, v
}

void expect_bounds(std::mt19937& random, double size, double spread) {
  const Bundle bundle(random, size, spread);
  const RayViewer viewer(bundle.pieces);
  const RayView view = viewer.view();
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const RayPiece& piece : bundle.pieces) {
    const RayPlace place = viewer.place_of(piece);
    const dvec3 met =
        piece.ray->origin + (piece.t_min + unit(random) * (piece.t_max - piece.t_min)) * piece.ray->direction;
    const dvec3 offset = random_vector(random, size), centre = met + offset, seen = in_view(view, centre);
    const double across =
        std::hypot(place.u + seen.x * place.u_slope - seen.y, place.v + seen.x * place.v_slope - seen.z);
    EXPECT_LE(across, view.stretch * glm::length(offset) + view.spread + 1e-6 * glm::length(centre));

    // A plane through the point that was met separates the ends of the piece, or the slack says so.
    const dvec3 normal = glm::normalize(random_vector(random, 1.0)), tilt = in_view(view, normal),
                foot = in_view(view, met);
    const double rise = tilt.y * place.u_slope + tilt.z * place.v_slope + tilt.x;
    const double height = tilt.y * (place.u + foot.x * place.u_slope - foot.y) +
                          tilt.z * (place.v + foot.x * place.v_slope - foot.z) + (place.middle - foot.x) * rise;
    EXPECT_LE(std::abs(height), place.half * std::abs(rise) + 4 * (view.spread + 4e-6 * glm::length(met)));
  }
}

TEST(RayView, HoldsWhatNearlyParallelRaysMeet) {
  std::mt19937 random(5);
  for (int bundle = 0; bundle < 2000; ++bundle) expect_bounds(random, 1e-3, 0.1);
}

TEST(RayView, HoldsWhatRaysOfAllDirectionsMeet) {
  std::mt19937 random(6);
  for (int bundle = 0; bundle < 2000; ++bundle) expect_bounds(random, 1e-3, 3.0);
}

TEST(RayView, SingleAndOppositeRaysHaveOne) {
  std::vector<SensorRay> rays(2);
  rays[0].direction = dvec3(0, 0, 1);
  rays[1].direction = dvec3(0, 0, -1);
  const RayPiece forth{&rays[0], 0, 0.0, 1e-3}, back{&rays[1], 1, 0.0, 1e-3};
  const RayView alone = RayViewer(std::vector<RayPiece>{forth}).view();
  EXPECT_FLOAT_EQ(1.0F, alone.stretch);
  EXPECT_FLOAT_EQ(1.0F, alone.z[0]);
  const RayView both = RayViewer(std::vector<RayPiece>{forth, back}).view();
  EXPECT_TRUE(std::isfinite(both.spread));
  EXPECT_TRUE(std::isfinite(both.x[0]) && std::isfinite(both.x[1]) && std::isfinite(both.x[2]));
}

}  // namespace
}  // namespace taxel
