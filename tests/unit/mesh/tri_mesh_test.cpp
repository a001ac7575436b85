// TriMesh: normals, areas, volume, shells and errors.
#include "core/mesh/tri_mesh.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::moved;
using test::together;

TEST(TriMesh, GivesVolumeAreaAndCentreOfABox) {
  const TriMesh box = moved(make_box({1, 2, 3}), {10, -20, 30});
  EXPECT_NEAR(box.volume(), 48, 1e-12);
  EXPECT_NEAR(box.area(), 88, 1e-12);
  EXPECT_NEAR(glm::distance(box.centroid(), dvec3(10, -20, 30)), 0, 1e-12);
  EXPECT_EQ(box.bounds().lo, dvec3(9, -22, 27));
  EXPECT_EQ(box.bounds().hi, dvec3(11, -18, 33));
  EXPECT_TRUE(box.closed());
  EXPECT_EQ(box.shell_count(), 1);
}

TEST(TriMesh, HasAnExactVolumeFarFromTheOrigin) {
  const double scale = 1e-3;
  const TriMesh box = moved(make_box(dvec3(scale)), dvec3(100.0));
  EXPECT_NEAR(box.volume() / (8 * scale * scale * scale), 1, 1e-9);
}

TEST(TriMesh, HasANegativeVolumeIfTheWindingIsReversed) {
  const TriMesh sphere = make_icosphere(1, 2), inside_out = flipped(sphere);
  EXPECT_DOUBLE_EQ(inside_out.volume(), -sphere.volume());
  EXPECT_DOUBLE_EQ(inside_out.area(), sphere.area());
  EXPECT_TRUE(inside_out.closed());
}

TEST(TriMesh, HasDiagonalVertexNormalsForAnyTriangulationOfABox) {
  const TriMesh box = make_box(dvec3(1));
  for (int v = 0; v < box.vertex_count(); ++v) {
    const dvec3 expected = glm::normalize(box.vertices()[static_cast<std::size_t>(v)]);
    EXPECT_NEAR(glm::distance(box.vertex_normals()[static_cast<std::size_t>(v)], expected), 0, 1e-12);
  }
}

TEST(TriMesh, HasTheMeanOfTheCornersAsCentroidOfATetrahedron) {
  const TriMesh tet({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  EXPECT_NEAR(tet.volume(), 1, 1e-15);
  EXPECT_NEAR(glm::distance(tet.centroid(), dvec3(0.25, 0.5, 0.75)), 0, 1e-15);
}

TEST(TriMesh, HasTheCentroidOfTheAreaIfOpen) {
  const TriMesh square({{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_FALSE(square.closed());
  EXPECT_NEAR(glm::distance(square.centroid(), dvec3(1, 1, 1)), 0, 1e-15);
}

TEST(TriMesh, NumbersShellsByTheirFirstFace) {
  const TriMesh two = together(make_box(dvec3(1)), moved(make_icosphere(1, 1), {5, 0, 0}));
  ASSERT_EQ(two.shell_count(), 2);
  EXPECT_EQ(two.shell_of_face().front(), 0);
  EXPECT_EQ(two.shell_of_face().back(), 1);
  EXPECT_TRUE(two.closed());
}

TEST(TriMesh, ExtractsShellsInFaceOrderWithoutOtherVertices) {
  const TriMesh ball = moved(make_icosphere(1, 1), {5, 0, 0});
  const TriMesh two = together(make_box(dvec3(1)), ball);
  std::vector<int> face_of;
  const TriMesh second = extract_shells(two, {1}, &face_of);
  EXPECT_EQ(second.vertex_count(), ball.vertex_count());
  ASSERT_EQ(second.face_count(), ball.face_count());
  for (int f = 0; f < second.face_count(); ++f) {
    EXPECT_EQ(face_of[static_cast<std::size_t>(f)], f + 12);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(second.vertex(f, c), two.vertex(f + 12, c));
  }
  EXPECT_THROW(extract_shells(two, {2}), Error);
}

TEST(TriMesh, FindsEnclosedShellsOfAnyWinding) {
  const TriMesh outer = make_icosphere(1, 2), cavity = flipped(make_box(dvec3(0.2)));
  const TriMesh hollow = together(cavity, outer);
  EXPECT_TRUE(shell_is_enclosed(hollow, 0));
  EXPECT_FALSE(shell_is_enclosed(hollow, 1));
  EXPECT_EQ(outer_shells(hollow), std::vector<int>{1});
  EXPECT_NEAR(hollow.volume(), outer.volume() - 0.064, 1e-12);
  EXPECT_EQ(outer_shells(together(outer, make_box(dvec3(0.2)))), std::vector<int>{0});
}

/// Returns a torus about z.
TriMesh ring(double radius, double thickness) {
  constexpr int kAround = 24, kAcross = 12;
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const double a = 2 * kPi * i / kAround, b = 2 * kPi * j / kAcross, r = radius + thickness * std::cos(b);
      vertices.emplace_back(r * std::cos(a), r * std::sin(a), thickness * std::sin(b));
      const int i1 = (i + 1) % kAround, j1 = (j + 1) % kAcross;
      faces.emplace_back(i * kAcross + j, i1 * kAcross + j, i1 * kAcross + j1);
      faces.emplace_back(i * kAcross + j, i1 * kAcross + j1, i * kAcross + j1);
    }
  }
  return {std::move(vertices), std::move(faces)};
}

TEST(TriMesh, FindsABallEnclosedInsideARingButNotInItsHole) {
  const TriMesh torus = ring(3, 1);
  ASSERT_TRUE(torus.closed());
  ASSERT_GT(torus.volume(), 0);
  const TriMesh ball = make_icosphere(0.5, 1);
  EXPECT_EQ(outer_shells(together(torus, ball)), (std::vector<int>{0, 1}));
  EXPECT_EQ(outer_shells(together(torus, moved(ball, {3, 0, 0}))), std::vector<int>{0});
}

TEST(TriMesh, RefusesInvalidFacesAndNamesThem) {
  const std::vector<dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const auto message = [&](const std::vector<dvec3>& vertices, const std::vector<ivec3>& faces) {
    try {
      const TriMesh mesh(vertices, faces);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(points, {{0, 1, 2}}), "");
  EXPECT_NE(message(points, {{0, 1, 2}, {0, 1, 4}}).find("face 1"), std::string::npos);
  EXPECT_NE(message(points, {{0, -1, 2}}).find("face 0"), std::string::npos);
  EXPECT_NE(message(points, {{0, 1, 1}}).find("face 0"), std::string::npos);
  EXPECT_NE(message(points, {{0, 1, 3}}).find("no area"), std::string::npos);
  EXPECT_NE(message({{0, 0, std::nan("")}}, {}).find("vertex 0"), std::string::npos);
}

TEST(TriMesh, KeepsTrianglesOfTenMicrometres) {
  const TriMesh tiny = make_icosphere(1e-5, 3);
  EXPECT_TRUE(tiny.closed());
  EXPECT_NEAR(tiny.volume() / make_icosphere(1, 3).volume() / 1e-15, 1, 1e-12);
}

TEST(TriMesh, IsNotClosedIfThreeFacesShareAnEdge) {
  const TriMesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  ASSERT_TRUE(tet.closed());
  std::vector<dvec3> vertices = tet.vertices();
  std::vector<ivec3> faces = tet.faces();
  vertices.emplace_back(1, 1, 1);
  faces.emplace_back(0, 1, 4);
  EXPECT_FALSE(TriMesh(vertices, faces).closed());
}

TEST(TriMesh, IsNotClosedIfTwoBodiesShareAnEdge) {
  const std::vector<ivec3> tet{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::vector<ivec3> faces = tet;
  const int other[4] = {0, 1, 4, 5};
  for (const ivec3& f : tet) faces.emplace_back(other[f.x], other[f.y], other[f.z]);
  const std::vector<dvec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  EXPECT_FALSE(TriMesh(vertices, faces).closed());
}

}  // namespace
}  // namespace taxel
