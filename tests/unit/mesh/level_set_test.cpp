// Level sets: closed meshes of the right volume, and errors.
#include "core/mesh/make/level_set.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace taxel {
namespace {

double torus(const dvec3& x) {
  const double q = std::hypot(x.x, x.y) - 0.03;
  return std::hypot(q, x.z) - 0.01;
}

int euler_number(const TriMesh& mesh) {
  return mesh.vertex_count() - 3 * mesh.face_count() / 2 + mesh.face_count();
}

TEST(LevelSet, MakesATorusOfItsFunction) {
  const Aabb box{{-0.04, -0.04, -0.01}, {0.04, 0.04, 0.01}};
  const TriMesh mesh = make_level_set(torus, box, 0.002);
  EXPECT_TRUE(mesh.closed());
  EXPECT_EQ(mesh.shell_count(), 1);
  EXPECT_EQ(euler_number(mesh), 0);
  const double volume = 2 * kPi * kPi * 0.03 * 0.01 * 0.01;
  EXPECT_NEAR(mesh.volume(), volume, 0.02 * volume);
  const double finer = make_level_set(torus, box, 0.001).volume();  // second-order convergence
  EXPECT_NEAR((volume - mesh.volume()) / (volume - finer), 4, 0.5);
  // Vertices are on the zero level, except those moved a thousandth of an edge away from the grid's nodes.
  for (const dvec3& v : mesh.vertices()) EXPECT_LT(std::abs(torus(v)), 0.0011 * 0.002 * std::sqrt(3.0));
  for (int f = 0; f < mesh.face_count(); f += 7) {
    if (mesh.face_areas()[static_cast<std::size_t>(f)] < 1e-8) continue;  // slivers may have any normal
    const dvec3 middle = (mesh.vertex(f, 0) + mesh.vertex(f, 1) + mesh.vertex(f, 2)) / 3.0;
    EXPECT_GT(torus(middle + 0.0002 * mesh.face_normals()[static_cast<std::size_t>(f)]), torus(middle));
  }
}

/// The zeros are exactly at nodes of the grid. Tets without a node inside are omitted, so the cube's edges are cut off
/// by at most half a cell.
TEST(LevelSet, IsClosedForAFunctionThatIsZeroOnTheGrid) {
  const auto cube = [](const dvec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) - 1.0; };
  const TriMesh mesh = make_level_set(cube, {dvec3(-1), dvec3(1)}, 0.25);
  EXPECT_TRUE(mesh.closed());
  EXPECT_EQ(euler_number(mesh), 2);
  EXPECT_LT(mesh.volume(), 8);
  EXPECT_GT(mesh.volume(), 8 - 12 * 2 * 0.5 * 0.25 * 0.25);
}

TEST(LevelSet, RefusesBadInput) {
  const auto message = [](const std::function<double(const dvec3&)>& distance, double edge) -> std::string {
    try {
      make_level_set(distance, {dvec3(-1), dvec3(1)}, edge);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(make_level_set([](const dvec3&) { return 1.0; }, {dvec3(-1), dvec3(1)}, 0.2).face_count(), 0);
  EXPECT_NE(message([](const dvec3& x) { return glm::length(x) - 2; }, 0.2).find("outside of its bounding box"),
            std::string::npos);
  EXPECT_NE(message([](const dvec3& x) { return std::sqrt(x.x); }, 0.2).find("nan"), std::string::npos);
  EXPECT_NE(message([](const dvec3& x) { return glm::length(x) - 1; }, 0).find("edge"), std::string::npos);
  EXPECT_NE(message([](const dvec3& x) { return glm::length(x) - 1; }, 1e-4).find("edge"), std::string::npos);
}

}  // namespace
}  // namespace taxel
