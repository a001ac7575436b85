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

}  // namespace
}  // namespace taxel
