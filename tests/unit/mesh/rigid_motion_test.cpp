// The motion between two copies of one mesh.
#include "core/mesh/compare.h"

#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

TEST(RigidMotion, IsThatOfTwoCopies) {
  const TriMesh box = make_box({0.01, 0.02, 0.03});
  const Pose X{glm::normalize(dquat(1, 2, 3, 4)), {1, 2, 3}};
  std::vector<dvec3> vertices = box.vertices();
  for (dvec3& v : vertices) v = X * v;
  const std::optional<Pose> found = find_rigid_motion(box, TriMesh(vertices, box.faces()), 1e-9);
  ASSERT_TRUE(found);
  for (const dvec3& v : box.vertices()) EXPECT_LT(glm::distance(*found * v, X * v), 1e-12);
  for (dvec3& v : vertices) v *= 1.01;
  EXPECT_FALSE(find_rigid_motion(box, TriMesh(vertices, box.faces()), 1e-9)) << "larger";
  for (dvec3& v : vertices) v.x = -v.x / 1.01;
  EXPECT_FALSE(find_rigid_motion(box, TriMesh(vertices, box.faces()), 1e-9)) << "mirrored";
  EXPECT_FALSE(find_rigid_motion(box, make_sphere(0.02, 0.008), 1e-9)) << "another mesh";
}

}  // namespace
}  // namespace taxel
