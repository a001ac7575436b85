// Intersecting faces: none in sound meshes, all those of a rod through a plate.
#include "core/mesh/query/self_intersection.h"

#include <gtest/gtest.h>

#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::moved;
using test::together;

TEST(SelfIntersections, AreEmptyForSoundMeshes) {
  EXPECT_EQ(find_self_intersections(make_icosphere(0.01, 3)).pairs, 0);
  EXPECT_EQ(find_self_intersections(make_fingertip()).pairs, 0);
  EXPECT_EQ(find_self_intersections(test::bumpy_sphere(3)).pairs, 0);
  const TriMesh box = make_box(dvec3(1));
  EXPECT_EQ(find_self_intersections(together(box, moved(box, {3, 0, 0}))).pairs, 0);
  EXPECT_EQ(find_self_intersections(together(box, moved(box, {2, 0, 0}))).pairs, 0);  // touching faces do not intersect
  const TriMesh spike{{{0.3, 0.1, 1}, {0.2, 0, 2}, {0.5, 0, 2}, {0.3, 0.4, 2}},
                      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  EXPECT_EQ(find_self_intersections(together(box, spike)).pairs, 0);
  EXPECT_GT(find_self_intersections(together(box, moved(spike, {0, 0, -0.1}))).pairs, 0);
}

/// A rod through a plate: its four long edges go through the plate's upper and lower face, two triangles each.
TEST(SelfIntersections, AreFoundAtTheirPlacesInTwoParts) {
  const TriMesh plate = make_box({1, 1, 0.1}), rod = moved(make_box({0.02, 0.03, 0.5}), {0.4, 0.1, 0.05});
  const SelfIntersections found = find_self_intersections(together(plate, rod));
  EXPECT_GT(found.pairs, 0);
  EXPECT_LT(found.face_a, 12);
  EXPECT_GE(found.face_b, 12);
  EXPECT_NEAR(std::abs(found.place.z), 0.1, 1e-12);
  EXPECT_NEAR(found.place.x, 0.4, 0.0201);
  EXPECT_NEAR(found.place.y, 0.1, 0.0301);
  bool told = false;
  for (const Problem& p : check_mesh(together(plate, rod), "a.obj")) told = told || p.code == "mesh_self_intersection";
  EXPECT_TRUE(told);
}

/// Returns crossing boxes and needles: many of their pairs, and faces without one.
TriMesh random_boxes() {
  test::RandomStream random(4);
  TriMesh all = make_box(dvec3(0.01));
  for (int i = 0; i < 60; ++i) {
    const dvec3 half(random.uniform(0.001, 0.01), random.uniform(0.001, 0.01), random.uniform(0.0001, 0.02));
    all = together(all, moved(make_box(half), 0.04 * random.in_cube(1)));
  }
  return all;
}

/// Returns true if an edge of one triangle goes through the inside of the other one, by the signs of volumes.
bool is_crossing(const TriMesh& mesh, int f, int g) {
  const auto volume = [](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    return glm::dot(glm::cross(b - a, c - a), d - a);
  };
  for (const auto& [edges, face] : {std::pair(f, g), std::pair(g, f)}) {
    const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
    for (int i = 0; i < 3; ++i) {
      const dvec3 &p = mesh.vertex(edges, i), &q = mesh.vertex(edges, (i + 1) % 3);
      const double x = volume(p, q, a, b), y = volume(p, q, b, c), z = volume(p, q, c, a);
      const bool is_inside = (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
      if (is_inside && volume(a, b, c, p) * volume(a, b, c, q) < 0) return true;
    }
  }
  return false;
}

TEST(SelfIntersections, AreThoseOfAllPairs) {
  const TriMesh mesh = random_boxes();
  std::vector<std::pair<int, int>> expected;
  std::vector<char> crosses(mesh.faces().size(), 0), crosses_own(mesh.faces().size(), 0);
  std::vector<int> halves;  // two groups of boxes as shells
  for (int f = 0; f < mesh.face_count(); ++f) halves.push_back(f < mesh.face_count() / 2 ? 0 : 1);
  const auto slot = [](int i) { return static_cast<std::size_t>(i); };
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int g = f + 1; g < mesh.face_count(); ++g) {
      if (mesh.shell_of_face()[slot(f)] == mesh.shell_of_face()[slot(g)] || !is_crossing(mesh, f, g)) continue;
      expected.emplace_back(f, g);
      crosses[slot(f)] = crosses[slot(g)] = 1;
      if (halves[slot(f)] == halves[slot(g)]) crosses_own[slot(f)] = crosses_own[slot(g)] = 1;
    }
  }
  ASSERT_GT(expected.size(), 100U);
  const std::vector<char> all(mesh.faces().size(), 1);
  const BoxTree tree = tree_of_faces(mesh);
  EXPECT_EQ(find_crossing_pairs(mesh.vertices(), mesh.faces(), all), expected);
  EXPECT_EQ(find_crossing_pairs(mesh.vertices(), mesh.faces(), tree, expected.size()), expected);
  EXPECT_FALSE(find_crossing_pairs(mesh.vertices(), mesh.faces(), tree, expected.size() - 1));
  EXPECT_EQ(find_crossing_faces(mesh.vertices(), mesh.faces(), tree, std::vector<int>(mesh.faces().size(), 0)),
            crosses);
  EXPECT_EQ(find_crossing_faces(mesh.vertices(), mesh.faces(), tree, halves), crosses_own);
  const SelfIntersections found = find_self_intersections(mesh);
  EXPECT_EQ(found.pairs, static_cast<int>(expected.size()));
  EXPECT_EQ(std::pair(found.face_a, found.face_b), expected.front());
}

TEST(SelfIntersections, EndTheSearchForFacesOnceItIsEnough) {
  test::RandomStream random(9);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int f = 0; f < 20000; ++f) {
    const dvec3 center = random.in_cube(1);
    for (int c = 0; c < 3; ++c) vertices.push_back(center + random.in_cube(0.05));
    faces.emplace_back(3 * f, 3 * f + 1, 3 * f + 2);
  }
  const TriMesh soup(std::move(vertices), std::move(faces));
  const std::vector<int> one_shell(soup.faces().size(), 0);
  const BoxTree tree = tree_of_faces(soup);
  const std::vector<char> all = find_crossing_faces(soup.vertices(), soup.faces(), tree, one_shell);
  std::vector<char> seen;
  const std::vector<char> some =
      find_crossing_faces(soup.vertices(), soup.faces(), tree, one_shell, [&](const std::vector<char>& crosses) {
        seen = crosses;
        return true;
      });
  EXPECT_EQ(some, seen);
  EXPECT_GT(std::count(some.begin(), some.end(), 1), 0);
  EXPECT_LT(std::count(some.begin(), some.end(), 1), std::count(all.begin(), all.end(), 1));
  for (std::size_t f = 0; f < some.size(); ++f) EXPECT_LE(some[f], all[f]);
}

}  // namespace
}  // namespace taxel
