// Shortest paths have the length of the geodesic distance and stay on the surface.
#include "core/mesh/geodesic.h"

#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "core/mesh/query/closest_point.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double length_of(const std::vector<dvec3>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += glm::distance(path[i - 1], path[i]);
  return length;
}

dvec3 point_of(const TriMesh& mesh, int face, test::RandomStream& random, int kind) {
  dvec3 w(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  const int corner = random.below(3);
  if (kind == 1) w[corner] = 0.0;
  if (kind == 2) w = dvec3(0.0), w[corner] = 1.0;
  w /= w.x + w.y + w.z;
  return w.x * mesh.vertex(face, 0) + w.y * mesh.vertex(face, 1) + w.z * mesh.vertex(face, 2);
}

void expect_paths(const TriMesh& mesh, int count, std::uint64_t seed) {
  test::RandomStream random(seed);
  const auto shared = std::make_shared<TriMesh>(mesh);
  const auto unfolded = std::make_shared<UnfoldedMesh>(shared);
  const MeshIndex index(shared);
  GeodesicDistance geodesic(unfolded);
  int bent = 0;
  for (int i = 0; i < count; ++i) {
    const int f = random.below(mesh.face_count()), g = random.below(mesh.face_count());
    const dvec3 a = point_of(mesh, f, random, i % 3), b = point_of(mesh, g, random, (i / 3) % 3);
    geodesic.propagate(f, a, kInfinity);
    const double distance = geodesic.to(g, b);
    const std::vector<dvec3> path = geodesic_path(*unfolded, geodesic, a, g, b);
    ASSERT_GE(path.size(), 2U);
    EXPECT_EQ(path.front(), a);
    EXPECT_EQ(path.back(), b);
    EXPECT_NEAR(length_of(path), distance, 1e-8 * distance) << "path " << i;
    for (std::size_t k = 1; k < path.size(); ++k) {
      const dvec3 middle = 0.5 * (path[k - 1] + path[k]);
      EXPECT_LT(index.closest_point(middle).distance, 1e-9 * mesh.bounds().diagonal()) << "path " << i;
    }
    bent += path.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(bent, count / 2);
}

TEST(GeodesicPath, IsAsLongAsTheDistanceAndOnTheSurface) {
  expect_paths(make_fingertip(), 60, 1);
  expect_paths(test::bumpy_sphere(2), 90, 2);
  expect_paths(make_box(dvec3(1, 2, 3)), 200, 3);
}

// Dudeney 1903: the path of length 40 crosses five of the six walls.
TEST(GeodesicPath, SolvesTheProblemOfTheSpiderAndTheFly) {
  const auto room = std::make_shared<TriMesh>(make_box(dvec3(15, 6, 6)));
  const MeshIndex index(room);
  const auto unfolded = std::make_shared<UnfoldedMesh>(room);
  GeodesicDistance geodesic(unfolded);
  const dvec3 spider(-15, 0, 5), fly(15, 0, -5);
  const int from = index.closest_point(spider).face, to = index.closest_point(fly).face;
  geodesic.propagate(from, spider, kInfinity);
  const std::vector<dvec3> path = geodesic_path(*unfolded, geodesic, spider, to, fly);
  EXPECT_NEAR(length_of(path), 40, 1e-10);
  EXPECT_GE(path.size(), 6U);
}

TEST(GeodesicPath, IsEmptyIfThereIsNoPath) {
  const TriMesh one = make_box(dvec3(1));
  std::vector<dvec3> vertices = one.vertices();
  std::vector<ivec3> faces = one.faces();
  for (const dvec3& v : one.vertices()) vertices.push_back(v + dvec3(5, 0, 0));
  for (const ivec3& f : one.faces()) faces.push_back(f + ivec3(8));
  const auto both = std::make_shared<TriMesh>(vertices, faces);
  const auto unfolded = std::make_shared<UnfoldedMesh>(both);
  GeodesicDistance geodesic(unfolded);
  const dvec3 a = both->vertex(0, 0), b = both->vertex(12, 0);
  geodesic.propagate(0, a, kInfinity);
  EXPECT_TRUE(geodesic_path(*unfolded, geodesic, a, 12, b).empty());
}

}  // namespace
}  // namespace taxel
