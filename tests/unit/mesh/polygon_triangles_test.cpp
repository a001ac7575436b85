// Polygons of mesh files become triangles that cover them, none of which is flat.
#include "core/mesh/formats/polygon_soup.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/base/rng.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

std::vector<ivec3> triangles_of(const std::vector<dvec3>& polygon) {
  std::vector<int> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0);
  std::vector<ivec3> triangles;
  add_polygon_triangles(polygon, corners, triangles);
  return triangles;
}

/// Twice the signed area in the plane z = 0 of a frame that `turn` leads to.
double twice_area(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& normal) {
  return glm::dot(glm::cross(b - a, c - a), normal);
}

/// Expects n - 2 triangles without flat or turned ones, whose areas add up to that of the polygon. Because each edge of
/// the polygon is an edge of one triangle then, they cover it.
void expect_covered(const std::vector<dvec3>& polygon, const dvec3& normal, const std::string& what) {
  const std::vector<ivec3> triangles = triangles_of(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2) << what;
  double whole = 0, sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    whole += glm::dot(glm::cross(polygon[i], polygon[(i + 1) % polygon.size()]), normal);
  for (const ivec3& t : triangles) {
    const auto at = [&](int k) { return polygon[static_cast<std::size_t>(t[k])]; };
    const double part = twice_area(at(0), at(1), at(2), normal);
    EXPECT_GT(part, 1e-9 * whole) << what;
    sum += part;
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole) << what;
}

TEST(PolygonTriangles, AreAFanOfAConvexPolygon) {
  const std::vector<ivec3> fan = triangles_of({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 2, 0}, {0, 1, 0}});
  EXPECT_EQ(fan, (std::vector<ivec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(PolygonTriangles, CoverPolygonsWithFlatAndConcaveCorners) {
  const dvec3 z(0, 0, 1);
  expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {0, 2, 0}}, z, "a lid of CAD");
  expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 2, 0}}, z, "a triangle with a corner on its side");
  expect_covered({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, z, "an L");
  expect_covered({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, z, "a U");
  expect_covered({{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}}, z, "an arrow");
  std::vector<dvec3> comb;
  for (int tooth = 0; tooth < 40; ++tooth) comb.insert(comb.begin(), {{2.0 * tooth + 1, 1, 0}, {2.0 * tooth, 3, 0}});
  comb.insert(comb.end(), {{0, 0, 0}, {30, 0, 0}, {79, 0, 0}});
  expect_covered(comb, z, "a comb");
}

TEST(PolygonTriangles, CoverRandomPolygonsInAnyPlane) {
  const CounterRng rng(3);
  std::uint64_t n = 0;
  for (int i = 0; i < 300; ++i) {
    const int corners = 4 + static_cast<int>(60 * rng.uniform(n++));
    const dvec3 normal = glm::normalize(dvec3(rng.uniform(n), rng.uniform(n + 1), rng.uniform(n + 2)) - 0.5);
    n += 3;
    const dvec3 u = any_perpendicular(normal), v = glm::cross(normal, u);
    std::vector<dvec3> polygon;  // a star about the origin, with some corners in the middle of an edge
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * kPi * k / corners, radius = 0.2 + rng.uniform(n++);
      polygon.push_back(radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    for (std::size_t k = 0; k + 1 < polygon.size(); k += 3)
      polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k) + 1, 0.5 * (polygon[k] + polygon[k + 1]));
    expect_covered(polygon, normal, fmt::format("polygon {}", i));
  }
}

TEST(PolygonTriangles, LeaveASolidWithFlatCornersClosed) {
  // A prism over a rectangle with corners on two sides; the faces stand before their vertices.
  const std::vector<dvec2> outline{{0, 0}, {0.005, 0}, {0.01, 0}, {0.02, 0}, {0.02, 0.01}, {0.01, 0.01}, {0, 0.01}};
  const auto n = static_cast<int>(outline.size());
  std::string faces = "f", lid = "f", vertices;
  for (int i = n; i > 0; --i) faces += fmt::format(" {}", i);
  for (int i = 1; i <= n; ++i) lid += fmt::format(" {}", n + i);
  faces += "\n" + lid + "\n";
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces += fmt::format("f {} {} {} {}\n", i + 1, next + 1, n + next + 1, n + i + 1);
  }
  for (const double z : {0.0, 0.006})
    for (const dvec2& x : outline) vertices += fmt::format("v {} {} {}\n", x.x, x.y, z);
  for (const std::string& text : {vertices + faces, faces + vertices}) {
    const LoadedMesh loaded = read_mesh(text, "prism.obj");
    EXPECT_TRUE(loaded.mesh->closed());
    EXPECT_EQ(loaded.mesh->face_count(), 4 * n - 4);
    EXPECT_NEAR(loaded.mesh->volume(), 0.02 * 0.01 * 0.006, 1e-15);
    EXPECT_EQ(loaded.notes, std::vector<std::string>{"cut 9 polygons into triangles"});
  }
}

}  // namespace
}  // namespace taxel
