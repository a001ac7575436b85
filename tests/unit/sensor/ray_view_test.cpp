// The view along the rays of a tet: the error bounds of its positions, compared with the rays.
#include "core/sensor/rays/sensor_ray.h"

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

/// Rays through a place about `size` wide, at most a metre from the origin, whose directions differ by about `spread`.
/// Every second ray points the other way.
struct Bundle {
  std::vector<SensorRay> rays;
  std::vector<const SensorRay*> seen;

  Bundle(std::mt19937& random, double size, double spread) {
    const dvec3 at = random_vector(random, 0.3), along = glm::normalize(random_vector(random, 1.0));
    rays.resize(13);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const dvec3 direction = glm::normalize(along + random_vector(random, spread));
      rays[i] = {static_cast<int>(i), at + random_vector(random, size), i % 2 == 0 ? direction : -direction, 10 * size};
      seen.push_back(&rays[i]);
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

/// Planes through points on the rays: the rays meet the planes at these points by the formula of sensor_ray.h in single
/// precision. Returns the number of cases that the view decides.
int expect_planes_met(std::mt19937& random, double size, double spread) {
  const Bundle bundle(random, size, spread);
  const RayViewer viewer(bundle.seen);
  const RayView view = viewer.view();
  int told = 0;
  for (const SensorRay& ray : bundle.rays) {
    const RayPlace place = viewer.place_of(ray);
    std::uniform_real_distribution<double> depth(0.0, ray.max_depth);
    const dvec3 met = ray.origin + depth(random) * ray.direction, normal = glm::normalize(random_vector(random, 1.0));
    const dvec3 beside = glm::cross(normal, random_vector(random, size)), centroid = met + beside;
    const glm::vec3 c(in_view(view, centroid)), n(in_view(view, normal)), expected(in_view(view, -beside));
    const float u = place.u + c.x * place.u_slope - c.y, v = place.v + c.x * place.v_slope - c.z;
    const float rise = n.x + n.y * place.u_slope + n.z * place.v_slope, height = n.y * u + n.z * v;
    const float x = u - height / rise * place.u_slope, y = v - height / rise * place.v_slope;
    const double coordinates = std::abs(c.x) + std::abs(c.y) + std::abs(c.z) + glm::length(beside);
    const double slack = (view.spread + kSingleRounding * coordinates) * (1 + view.tilt / std::abs(rise));
    EXPECT_LE(std::hypot(x - expected.y, y - expected.z), slack);
    told += slack < 0.1 * size;
  }
  return told;
}

TEST(RayView, LocatesNearlyParallelRaysOnPlanes) {
  std::mt19937 random(5);
  int told = 0;
  for (int bundle = 0; bundle < 2000; ++bundle) told += expect_planes_met(random, 1e-3, 0.1);
  EXPECT_GT(told, 20000) << "of 26000";
}

TEST(RayView, DecidesNothingForRaysOfAllDirections) {
  std::mt19937 random(6);
  int told = 0;
  for (int bundle = 0; bundle < 2000; ++bundle) told += expect_planes_met(random, 1e-3, 3.0);
  EXPECT_LT(told, 100);
}

TEST(RayView, ExistsForSingleAndOppositeRays) {
  std::vector<SensorRay> rays(2);
  rays[0].direction = dvec3(0, 0, 1);
  rays[1].direction = dvec3(0, 0, -1);
  const SensorRay* both[] = {&rays[0], &rays[1]};
  for (const std::size_t count : {1U, 2U}) {
    const RayView view = RayViewer(std::span(both).first(count)).view();
    EXPECT_EQ(view.spread, 0.0F) << "all at the origin";
    EXPECT_EQ(view.tilt, 0.0F);
    EXPECT_FLOAT_EQ(view.z[0], 1.0F);
  }
}

}  // namespace
}  // namespace taxel
