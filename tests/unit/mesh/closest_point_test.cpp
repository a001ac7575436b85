// Nearest points, ray hits and signed distances against brute force and closed forms.
#include "core/mesh/query/closest_point.h"

#include <gtest/gtest.h>

#include "core/mesh/query/nearest.h"
#include "core/mesh/query/triangle.h"
#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

std::shared_ptr<const TriMesh> share(TriMesh mesh) {
  return std::make_shared<const TriMesh>(std::move(mesh));
}

/// Returns the shortest distance by dense sampling of the triangle: an upper bound that converges.
double sampled_distance(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  double best = std::numeric_limits<double>::infinity();
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const dvec3 q = a + (b - a) * (static_cast<double>(i) / kSteps) + (c - a) * (static_cast<double>(j) / kSteps);
      best = std::min(best, glm::distance(p, q));
    }
  }
  return best;
}

TEST(PointTriangle, AgreesWithDenseSampling) {
  test::RandomStream random(1);
  for (int i = 0; i < 300; ++i) {
    const dvec3 a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1), p = random.in_cube(2);
    const TrianglePoint q = nearest_on_triangle(p, a, b, c);
    const double sampled = sampled_distance(p, a, b, c);
    EXPECT_LE(std::sqrt(q.squared_distance), sampled * (1 + 1e-12));
    EXPECT_GT(std::sqrt(q.squared_distance), sampled - 0.02);
    const dvec3 w = q.barycentric;
    EXPECT_NEAR(glm::distance(w.x * a + w.y * b + w.z * c, q.position), 0, 1e-12);
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
    EXPECT_GE(std::min({w.x, w.y, w.z}), 0);
    EXPECT_NEAR(glm::distance(p, q.position), std::sqrt(q.squared_distance), 1e-12);
  }
}

TEST(PointTriangle, IsExactOnNeedles) {
  const dvec3 a(0, 0, 0), b(1, 0, 0), c(0.5, 1e-12, 0);
  for (const double x : {-0.5, 0.0, 0.3, 0.5, 0.9, 1.5}) {
    const TrianglePoint q = nearest_on_triangle({x, 0, 0.7}, a, b, c);
    const double beyond = std::max({0.0, -x, x - 1});
    EXPECT_NEAR(q.squared_distance, 0.49 + beyond * beyond, 1e-11);
  }
}

/// Returns the lowest of the nearest faces, by testing all faces.
SurfacePoint brute_force(const TriMesh& mesh, const dvec3& p) {
  SurfacePoint best;
  double best_squared = std::numeric_limits<double>::infinity();
  for (int f = 0; f < mesh.face_count(); ++f) {
    const TrianglePoint q = nearest_on_triangle(p, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2));
    if (q.squared_distance >= best_squared) continue;
    best_squared = q.squared_distance;
    best = {q.position, f, q.barycentric, std::sqrt(q.squared_distance)};
  }
  return best;
}

void expect_same(const SurfacePoint& a, const SurfacePoint& b) {
  EXPECT_EQ(a.face, b.face);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.barycentric, b.barycentric);
  EXPECT_EQ(a.distance, b.distance);
}

TEST(MeshIndex, FindsTheClosestPointOfBruteForce) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const MeshIndex index(share(test::random_soup(seed, 400)));
    test::RandomStream random(seed + 100);
    for (int i = 0; i < 500; ++i) {
      dvec3 p = random.in_cube(1.5);
      if (i % 3 == 0) p = index.mesh().vertex(random.below(index.mesh().face_count()), 0);  // exact ties
      if (i % 3 == 1) p.z = 0.25;
      const SurfacePoint nearest = brute_force(index.mesh(), p);
      expect_same(index.closest_point(p), nearest);
      expect_same(index.closest_point(p, 1.5 * nearest.distance), nearest);
      if (nearest.distance == 0.0) continue;
      EXPECT_EQ(index.closest_point(p, 0.9 * nearest.distance).face, -1) << "no point is that near";
    }
  }
}

TEST(MeshIndex, FindsTheClosestPointOfAPointAtAnyDistance) {
  const MeshIndex index(share(make_icosphere(0.01, 2)));
  for (const dvec3 direction : {dvec3(1, 0, 0), dvec3(-0.3, 0.8, 0.5), dvec3(1, -1, 1)}) {
    for (const double distance : {1e120, 1e155, 1e200, 1e308}) {
      const SurfacePoint far = index.closest_point(distance * direction);
      ASSERT_GE(far.face, 0) << distance;
      EXPECT_NEAR(glm::length(far.position), 0.01, 5e-4)
          << "a point of the mesh; all are equally far in this precision";
      EXPECT_NEAR(far.distance / distance, glm::length(direction), 1e-12 * glm::length(direction)) << distance;
    }
    EXPECT_EQ(index.closest_point(1e200 * direction, 1.0).face, -1) << "no point is that near";
  }
}

TEST(MeshIndex, ResolvesTiesToTheLowestFace) {
  const MeshIndex index(share(make_icosphere(1, 3)));
  test::RandomStream random(5);
  const TriMesh& mesh = index.mesh();
  for (int i = 0; i < 500; ++i) {
    // All faces at a vertex or an edge are equally near to a point above it.
    const int face = random.below(mesh.face_count());
    const double part = i % 2 == 0 ? 0.0 : random.uniform(0.1, 0.9);
    const dvec3 p = 1.7 * glm::mix(mesh.vertex(face, 0), mesh.vertex(face, 1), part);
    const SurfacePoint q = index.closest_point(p);
    expect_same(q, brute_force(mesh, p));
    EXPECT_LE(q.face, face);
  }
}

std::optional<MeshHit> brute_force_cast(const TriMesh& mesh, const Ray& ray, int except = -1) {
  std::optional<MeshHit> best;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (f == except) continue;
    const auto hit = intersect_triangle(ray, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2));
    if (hit && (!best || hit->t < best->t)) best = MeshHit{hit->t, f, hit->barycentric};
  }
  return best;
}

TEST(MeshIndex, CastsLikeBruteForce) {
  int hits = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const MeshIndex index(share(test::random_soup(seed, 400)));
    test::RandomStream random(seed + 200);
    for (int i = 0; i < 1000; ++i) {
      Ray ray{random.in_cube(1.5), random.direction()};
      const TriMesh& mesh = index.mesh();
      const int face = random.below(mesh.face_count());
      const dvec3 centre = (mesh.vertex(face, 0) + mesh.vertex(face, 1) + mesh.vertex(face, 2)) / 3.0;
      if (i % 3 == 0) ray.direction = glm::normalize(centre - ray.origin);
      if (i % 3 == 1) ray = {centre + dvec3(0, 0, 2), {0, 0, -1}};
      if (i % 5 == 0) ray.t_max = random.uniform(0, 3);
      const int except = i % 2 == 0 ? -1 : face;
      const auto hit = index.cast_except(ray, except), expected = brute_force_cast(mesh, ray, except);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(hit->face, expected->face);
      EXPECT_EQ(hit->t, expected->t);
      EXPECT_EQ(hit->barycentric, expected->barycentric);
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(MeshIndex, LetsNoRayThroughAVertexOrAnEdge) {
  const MeshIndex index(share(make_icosphere(1, 3)));
  const TriMesh& mesh = index.mesh();
  test::RandomStream random(10);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const double part : {0.0, 0.5, random.uniform(0, 1)}) {
      const dvec3 origin = random.in_cube(0.5);
      const dvec3 target = glm::mix(mesh.vertex(f, 0), mesh.vertex(f, 1), part);
      const auto hit = index.cast({origin, glm::normalize(target - origin)});
      ASSERT_TRUE(hit) << "face " << f;
      EXPECT_NEAR(hit->t, glm::distance(origin, target), 1e-12);
    }
  }
}

TEST(MeshIndex, CastsPastTheExceptedFace) {
  const MeshIndex index(share(make_box(dvec3(1))));
  const auto down = index.cast({{0.1, 0.2, 3}, {0, 0, -1}});
  ASSERT_TRUE(down);
  EXPECT_DOUBLE_EQ(down->t, 2);
  const auto through = index.cast_except({{0.1, 0.2, 1}, {0, 0, -1}}, down->face);
  ASSERT_TRUE(through);
  EXPECT_DOUBLE_EQ(through->t, 2);
  EXPECT_FALSE(index.cast({{0.1, 0.2, 3}, {0, 0, 1}}));
  EXPECT_FALSE(index.cast({{0.1, 0.2, 3}, {0, 0, -1}, 1.9}));
}

/// Returns the distance to the box |x| <= 1, negative inside.
double box_distance(const dvec3& p) {
  const dvec3 d = glm::abs(p) - 1.0;
  return glm::length(glm::max(d, dvec3(0))) + std::min(std::max({d.x, d.y, d.z}), 0.0);
}

TEST(MeshIndex, GivesTheExactSignedDistanceOfABox) {
  const MeshIndex index(share(make_box(dvec3(1))));
  test::RandomStream random(6);
  for (int i = 0; i < 3000; ++i) {
    dvec3 p = random.in_cube(2);
    if (i % 4 == 0) p = glm::round(4.0 * p) / 4.0;  // on the planes of faces, edges and corners
    EXPECT_NEAR(index.signed_distance(p), box_distance(p), 1e-14);
  }
}

TEST(MeshIndex, GivesTheCorrectSignAtSharpSpikes) {
  // A thin tetrahedron: at its spike the normal of any single face gives the wrong sign for points nearby.
  const MeshIndex index(share(
      TriMesh({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0.03, 0.03, 5}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})));
  test::RandomStream random(7);
  for (int i = 0; i < 3000; ++i) {
    const dvec3 p = dvec3(0.03, 0.03, 5) + random.in_cube(0.2);
    bool inside = true;
    for (int f = 0; f < 4; ++f)
      inside = inside &&
               glm::dot(p - index.mesh().vertex(f, 0), index.mesh().face_normals()[static_cast<std::size_t>(f)]) < 0;
    EXPECT_EQ(index.signed_distance(p) < 0, inside);
  }
}

TEST(MeshIndex, AgreesWithRayParityOnANonConvexMesh) {
  const MeshIndex index(share(test::bumpy_sphere(3)));
  test::RandomStream random(8);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 p = random.in_cube(1.4);
    const Ray ray{p, random.direction()};
    int crossings = 0;
    const TriMesh& mesh = index.mesh();
    for (int f = 0; f < mesh.face_count(); ++f)
      crossings += intersect_triangle(ray, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2)) ? 1 : 0;
    EXPECT_EQ(index.signed_distance(p) < 0, crossings % 2 == 1);
  }
}

Aabb box_of_corners(const TriMesh& mesh, int face) {
  Aabb box;
  for (int c = 0; c < 3; ++c) box.include(mesh.vertex(face, c));
  return box;
}

/// Returns a bumpy sphere of radius 1 around a point that may be far from the origin.
std::shared_ptr<const TriMesh> sphere_at(const dvec3& center) {
  const TriMesh sphere = test::bumpy_sphere(3);
  std::vector<dvec3> vertices = sphere.vertices();
  for (dvec3& v : vertices) v += center;
  return std::make_shared<const TriMesh>(std::move(vertices), sphere.faces());
}

TEST(NearestInTurn, FindsThePointsOfTheIndex) {
  test::RandomStream random(8);
  const MeshIndex index(sphere_at({3, 0, 0}));
  NearestInTurn nearest(index);
  dvec3 p(3, 0, 0);
  for (int i = 0; i < 2000; ++i) {
    p = i % 50 == 0 ? dvec3(3, 0, 0) + random.in_cube(4) : p + 0.05 * random.in_cube(1);
    const SurfacePoint found = nearest.closest_point(p), expected = index.closest_point(p);
    EXPECT_EQ(found.face, expected.face);
    EXPECT_EQ(found.position, expected.position);
  }
}

TEST(BoxTree, VisitsAllFacesWhoseBoxesOverlap) {
  test::RandomStream random(5);
  for (const double away : {0.0, 1000.0}) {
    const auto mesh = sphere_at(dvec3(away));
    const BoxTree tree = tree_of_faces(*mesh);
    for (int i = 0; i < 200; ++i) {
      Aabb box;
      box.include(dvec3(away) + random.in_cube(1));
      box.include(box.lo + 0.1 * random.in_cube(1));
      std::vector<int> visited(mesh->faces().size(), 0);
      tree.visit_overlapping(box, [&](int face) { ++visited[static_cast<std::size_t>(face)]; });
      for (int f = 0; f < mesh->face_count(); ++f) {
        const int times = visited[static_cast<std::size_t>(f)];
        EXPECT_LE(times, 1);
        if (box_of_corners(*mesh, f).overlaps(box)) {
          EXPECT_EQ(times, 1) << f;
        }
      }
    }
  }
}

TEST(BoxTree, HasEachFaceInTheLeavesOfOneNode) {
  const auto mesh = sphere_at({0, 0, 0});
  for (const Bvh::Effort effort : {Bvh::Effort::many_queries, Bvh::Effort::few_queries}) {
    const BoxTree tree = tree_of_faces(*mesh, effort);
    std::vector<int> times(mesh->faces().size(), 0);
    for (int node = 0; node < tree.node_count(); ++node) {
      const BoxTree::Leaves leaves = tree.leaves_of(node);
      for (int i = 0; i < leaves.count; ++i)
        ++times[static_cast<std::size_t>(leaves.primitives[static_cast<std::size_t>(i)])];
    }
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
  }
}

TEST(BoxTree, EndsAVisitWhenATestReturnsTrue) {
  const auto mesh = sphere_at({0, 0, 0});
  int visited = 0;
  tree_of_faces(*mesh).visit_overlapping(mesh->bounds(), [&](int) { return ++visited == 7; });
  EXPECT_EQ(visited, 7);
}

TEST(BoxTree, VisitsABoxThatOnlyTouches) {
  const auto mesh = sphere_at({0, 0, 0});
  const BoxTree tree = tree_of_faces(*mesh);
  for (int f = 0; f < mesh->face_count(); ++f) {
    const Aabb own = box_of_corners(*mesh, f);
    Aabb corner;
    corner.include(own.hi);
    bool is_visited = false;
    tree.visit_overlapping(corner, [&](int face) { is_visited = is_visited || face == f; });
    EXPECT_TRUE(is_visited) << f;
  }
}

TEST(BoxTree, FindsFacesNearAPointInAscendingOrder) {
  test::RandomStream random(6);
  const MeshIndex index(sphere_at({3, 0, 0}));
  for (int i = 0; i < 200; ++i) {
    const dvec3 p = dvec3(3, 0, 0) + random.in_cube(1.2);
    const double reach = 0.3;
    const std::vector<int> faces = index.faces_near(p, reach);
    EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
    for (int f = 0; f < index.mesh().face_count(); ++f) {
      const Aabb box = box_of_corners(index.mesh(), f);
      if (glm::distance(glm::clamp(p, box.lo, box.hi), p) > reach) continue;
      EXPECT_TRUE(std::binary_search(faces.begin(), faces.end(), f)) << f;
    }
  }
}

TEST(BoxTree, LetsNoFarRayThroughAVertex) {
  const auto mesh = sphere_at({0.7, -2, 5});
  const MeshIndex index(mesh);
  for (const double away : {10.0, 1e6, 1e10}) {
    for (const dvec3& v : mesh->vertices()) {
      const dvec3 origin = v + dvec3(0, 0, away);
      const RayTriangleTest test({origin, {0, 0, -1}});
      bool hits = false;
      for (int f = 0; f < mesh->face_count() && !hits; ++f)
        hits = test(mesh->vertex(f, 0), mesh->vertex(f, 1), mesh->vertex(f, 2), std::numeric_limits<double>::infinity())
                   .has_value();
      EXPECT_EQ(index.cast({origin, {0, 0, -1}}).has_value(), hits) << away;
    }
  }
}

TEST(BoxTree, GivesTheReportOfAMeshThatBuildsItsOwnTree) {
  std::vector<dvec3> vertices = test::bumpy_sphere(3).vertices();
  vertices[7] *= -0.9;  // a spike through the other side
  const auto mesh = std::make_shared<const TriMesh>(std::move(vertices), test::bumpy_sphere(3).faces());
  const MeshFindings with_tree = mesh_report(MeshIndex(mesh), {}), own = mesh_report(*mesh, {});
  ASSERT_FALSE(own.empty());
  ASSERT_EQ(with_tree.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) EXPECT_EQ(with_tree[i].what, own[i].what);
}

}  // namespace
}  // namespace taxel
