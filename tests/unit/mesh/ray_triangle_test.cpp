// Rays against triangles: hits, misses and watertight edges.
#include "core/mesh/query/triangle.h"

#include <gtest/gtest.h>

#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

TEST(RayTriangle, HitsThePointOfTheWeights) {
  test::RandomStream random(1);
  for (int i = 0; i < 10000; ++i) {
    const dvec3 a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1);
    const double u = random.uniform(0.02, 0.9), v = random.uniform(0.02, 0.95 - u);
    const dvec3 target = u * a + v * b + (1 - u - v) * c, origin = random.in_cube(3);
    const Ray ray{origin, glm::normalize(target - origin)};
    const dvec3 normal = glm::cross(b - a, c - a);
    if (std::abs(glm::dot(glm::normalize(normal), ray.direction)) < 1e-3 || glm::length(normal) < 1e-2) continue;
    const auto hit = intersect_triangle(ray, a, b, c);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, glm::distance(origin, target), 1e-10);
    EXPECT_NEAR(glm::distance(hit->barycentric, dvec3(u, v, 1 - u - v)), 0, 1e-9);
    EXPECT_TRUE(intersect_triangle(ray, c, b, a));  // from either side
    EXPECT_FALSE(intersect_triangle({origin, -ray.direction}, a, b, c));
    EXPECT_FALSE(intersect_triangle({origin, ray.direction, 0.99 * hit->t}, a, b, c));
    const dvec3 beside = a + 1.05 * (target - a) / (1 - u);  // beyond the edge b c
    EXPECT_FALSE(intersect_triangle({origin, glm::normalize(beside - origin)}, a, b, c));
  }
}

TEST(RayTriangle, DoesNotDependOnTheUnit) {
  // The hit is the same for a triangle of 1e-9 m and of 1e9 m, because there are no absolute epsilons.
  for (const double unit : {1e-9, 1e-6, 1.0, 1e9}) {
    const dvec3 a = unit * dvec3(0, 0, 1), b = unit * dvec3(1, 0, 1), c = unit * dvec3(0, 1, 1);
    const auto hit = intersect_triangle({unit * dvec3(0.25, 0.5, 0), {0, 0, 1}}, a, b, c);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t / unit, 1, 1e-14);
    EXPECT_NEAR(glm::distance(hit->barycentric, dvec3(0.25, 0.25, 0.5)), 0, 1e-14);
  }
}

TEST(RayTriangle, IncludesTheRimAndMissesInItsPlane) {
  const dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  for (const dvec3& p : {a, b, c, dvec3(0.5, 0, 0), dvec3(0.5, 0.5, 0)})
    EXPECT_TRUE(intersect_triangle({p + dvec3(0, 0, 2), {0, 0, -1}}, a, b, c));
  EXPECT_FALSE(intersect_triangle({{-1, 0.25, 0}, {1, 0, 0}}, a, b, c));
  EXPECT_TRUE(intersect_triangle({{0.25, 0.25, 0}, {0, 0, 1}}, a, b, c)) << "a start on the triangle is a hit at 0";
}

TEST(RayTriangle, LetsNoRayThroughASharedEdge) {
  // Two triangles share a random edge. The rays aim at points of the edge to within rounding.
  test::RandomStream random(3);
  int both = 0;
  for (int i = 0; i < 200000; ++i) {
    const dvec3 a = random.in_cube(1), b = random.in_cube(1);
    const dvec3 side = glm::normalize(glm::cross(b - a, random.direction()));
    const dvec3 left = 0.5 * (a + b) + side, right = 0.5 * (a + b) - side + 0.3 * random.direction();
    const dvec3 target = glm::mix(a, b, random.uniform(0.05, 0.95));
    const dvec3 across = glm::normalize(glm::cross(side, b - a));
    const dvec3 origin = target + 3.0 * across + random.in_cube(0.5);
    const Ray ray{origin, glm::normalize(target - origin)};
    const bool hit_left = intersect_triangle(ray, a, b, left).has_value();
    const bool hit_right = intersect_triangle(ray, b, a, right).has_value();
    ASSERT_TRUE(hit_left || hit_right) << i;
    both += hit_left && hit_right ? 1 : 0;
  }
  EXPECT_LT(both, 100000);
}

TEST(RayTriangle, LetsNoRayThroughAClosedMesh) {
  const TriMesh sphere = make_icosphere(1, 3);
  test::RandomStream random(4);
  for (int v = 0; v < sphere.vertex_count(); ++v) {
    const dvec3 origin = random.in_cube(0.3);
    const Ray ray{origin, glm::normalize(sphere.vertices()[static_cast<std::size_t>(v)] - origin)};
    int hits = 0;
    for (int f = 0; f < sphere.face_count(); ++f)
      hits += intersect_triangle(ray, sphere.vertex(f, 0), sphere.vertex(f, 1), sphere.vertex(f, 2)) ? 1 : 0;
    EXPECT_GE(hits, 1) << "vertex " << v;
  }
}

}  // namespace
}  // namespace taxel
