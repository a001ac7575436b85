// Nearest points from guesses, compared with the search in the tree.
#include "core/mesh/query/nearest.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

/// Compares both searches at points along a random walk through the box of a mesh. Every fifth guess is random.
void expect_equal_on_a_walk(const TriMesh& mesh, double most) {
  const MeshIndex index(std::make_shared<TriMesh>(mesh));
  const NearestGuess nearest(index, most);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const Aabb& box = mesh.bounds();
  const double size = box.diagonal();
  dvec3 x = box.center();
  int guess = -1;
  for (int i = 0; i < 20000; ++i) {
    x += 0.02 * size * (dvec3(unit(random), unit(random), unit(random)) - 0.5);
    if (i % 50 == 0) x = box.lo + dvec3(unit(random), unit(random), unit(random)) * box.extent();
    if (i % 5 == 0) guess = static_cast<int>(unit(random) * mesh.face_count());
    const SurfacePoint expected = index.closest_point(x), found = nearest.closest_point(x, guess);
    ASSERT_NEAR(found.distance, expected.distance, 1e-12 * size) << i;
    ASSERT_NEAR(glm::distance(found.position, x), found.distance, 1e-12 * size) << i;
    ASSERT_EQ(found.face, guess) << i;
  }
}

TEST(NearestGuess, EqualsTheSearchInTheTreeOnAFinger) {
  const LoadedMesh finger = load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", dvec3(1));
  expect_equal_on_a_walk(*finger.mesh, 0.002);
  expect_equal_on_a_walk(*finger.mesh, 0.006);
}

TEST(NearestGuess, EqualsTheSearchInTheTreeOnABox) {
  expect_equal_on_a_walk(make_box(dvec3(0.01, 0.02, 0.005)), 0.004);
}

}  // namespace
}  // namespace taxel
