#include "core/mesh/tlas.h"

#include <gtest/gtest.h>

#include "core/mesh/ray_triangle.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

TEST(Tlas, FindsTheFirstHitOfAllTreesWithTiesToTheLowestInstance) {
  std::vector<TriMesh> meshes;
  for (std::uint64_t i = 0; i < 6; ++i) meshes.push_back(test::random_soup(i, 60));
  meshes.push_back(meshes[2]);  // a twin: every hit of one is a tie with the other
  meshes.emplace_back(std::vector<dvec3>{}, std::vector<ivec3>{});
  std::vector<Bvh> trees;
  for (const TriMesh& mesh : meshes) {
    std::vector<Aabb> boxes(mesh.faces().size());
    for (int f = 0; f < mesh.face_count(); ++f) {
      for (int c = 0; c < 3; ++c) boxes[static_cast<std::size_t>(f)].include(mesh.vertex(f, c));
    }
    trees.emplace_back(boxes);
  }
  std::vector<const Bvh*> pointers;
  for (const Bvh& tree : trees) pointers.push_back(&tree);
  Tlas tlas;
  tlas.build(pointers);

  struct Best {
    double t = 10;
    std::pair<int, int> id{-1, -1};
    bool operator==(const Best&) const = default;
  };
  const auto try_face = [&](const Ray& ray, int instance, int face, Best& best) {
    const TriMesh& m = meshes[static_cast<std::size_t>(instance)];
    const auto hit = intersect_triangle({ray.origin, ray.direction, best.t}, m.vertex(face, 0), m.vertex(face, 1),
                                        m.vertex(face, 2));
    const std::pair id(instance, face);
    if (hit && (best.id.first < 0 || hit->t < best.t || id < best.id)) best = {hit->t, id};
    return best.t;
  };
  test::RandomStream random(9);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{random.in_cube(1), i % 4 == 0 ? dvec3(0, 0, 1) : random.direction(), 10};
    Best found, expected;
    const double t =
        tlas.cast(ray, [&](int instance, int face, double) { return try_face(ray, instance, face, found); });
    for (int m = 0; m < static_cast<int>(meshes.size()); ++m) {
      for (int f = 0; f < meshes[static_cast<std::size_t>(m)].face_count(); ++f) try_face(ray, m, f, expected);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(t, expected.t);
    EXPECT_NE(found.id.first, 6) << "the twin of 2 must never win";
    hits += found.id.first >= 0 ? 1 : 0;
  }
  EXPECT_GT(hits, 300);
}

TEST(Tlas, KeepsItsMemoryAndTakesNothing) {
  const std::vector<Aabb> boxes(20, Aabb{dvec3(0), dvec3(1)});
  const Bvh tree(boxes), empty;
  Tlas tlas;
  tlas.build(std::vector<const Bvh*>{&tree, &empty, &tree});
  const void* nodes = tlas.top().nodes().data();
  tlas.build(std::vector<const Bvh*>{&tree, &empty, &tree});
  EXPECT_EQ(tlas.top().nodes().data(), nodes);
  tlas.build({});
  EXPECT_EQ(tlas.cast({{0, 0, 0}, {0, 0, 1}, 5.0}, [](int, int, double) { return 0.0; }), 5.0);
}

}  // namespace
}  // namespace taxel
