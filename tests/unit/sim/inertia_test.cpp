// Mass and inertia of meshes compared with closed forms.
#include "core/sim/scene/inertia.h"

#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

TEST(Inertia, IsCorrectForABoxAwayFromTheOrigin) {
  std::vector<dvec3> vertices = make_box({0.1, 0.2, 0.3}).vertices();
  for (dvec3& v : vertices) v += dvec3(1, 2, 3);
  const Inertia inertia = solid_inertia(TriMesh(vertices, make_box({0.1, 0.2, 0.3}).faces()), 6.0);
  EXPECT_LT(glm::distance(inertia.center, dvec3(1, 2, 3)), 1e-14);
  EXPECT_NEAR(inertia.moment[0][0], 6.0 / 3 * (0.04 + 0.09), 1e-12);
  EXPECT_NEAR(inertia.moment[1][1], 6.0 / 3 * (0.01 + 0.09), 1e-12);
  EXPECT_NEAR(inertia.moment[2][2], 6.0 / 3 * (0.01 + 0.04), 1e-12);
  EXPECT_NEAR(inertia.moment[0][1], 0, 1e-13);
}

TEST(Inertia, HasTheProductsOfATetrahedron) {
  // Right-angled corner at the origin with sides 1: products of inertia about the centroid are +m/80 off the diagonal.
  const TriMesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const Inertia inertia = solid_inertia(tet, 1.0);
  EXPECT_NEAR(inertia.moment[0][0], 2 * 3.0 / 80, 1e-14);
  EXPECT_NEAR(inertia.moment[0][1], 1.0 / 80, 1e-14);
}

TEST(Inertia, IsThatOfTheBoxForAnOpenMesh) {
  const TriMesh sheet({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Inertia inertia = solid_inertia(sheet, 12.0);
  EXPECT_NEAR(inertia.moment[2][2], 12.0 * (4 + 1) / 12, 1e-12);
  EXPECT_EQ(inertia.center, dvec3(1, 0.5, 0));
}

}  // namespace
}  // namespace taxel
