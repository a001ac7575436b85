// Geometry for drawing: normals with creases, edges, rings of fields, simplified meshes and the order by depth.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/render_mesh.h"

namespace taxel::ui {
namespace {

double total_length(const std::vector<RingPiece>& ring) {
  double sum = 0;
  for (const RingPiece& piece : ring) sum += glm::length(piece.b - piece.a);
  return sum;
}

/// Returns two large triangles in the plane z = 0.
TriMesh square(double half) {
  return TriMesh({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(CreaseNormals, KeepTheFacesOfABoxFlat) {
  const RenderMesh mesh = make_render_mesh(make_box({1, 2, 3}));
  EXPECT_EQ(mesh.vertices.size(), 24u);
  ASSERT_EQ(mesh.indices.size(), 36u);
  for (const auto& v : mesh.vertices) {
    EXPECT_NEAR(std::max({std::abs(v.normal.x), std::abs(v.normal.y), std::abs(v.normal.z)}), 1.0f, 1e-6f);
    EXPECT_GT(glm::dot(v.normal, v.position), 0);
  }
}

TEST(CreaseNormals, SmoothASphereAndKeepTheOrderOfFaces) {
  const TriMesh sphere = make_icosphere(0.5, 3);
  const RenderMesh mesh = make_render_mesh(sphere);
  EXPECT_EQ(mesh.vertices.size(), sphere.vertices().size());
  for (const auto& v : mesh.vertices) EXPECT_GT(glm::dot(v.normal, glm::normalize(v.position)), std::cos(0.02f));
  for (int f = 0; f < sphere.face_count(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto i = mesh.indices[static_cast<std::size_t>(3 * f + k)];
      EXPECT_EQ(mesh.vertices[i].position, glm::vec3(sphere.vertex(f, k)));
    }
  }
}

TEST(CreaseNormals, SplitVerticesAtASeamOfATexture) {
  const std::vector<glm::vec2> even{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  std::vector<glm::vec2> seam = even;
  seam[4] = {0.5f, 0.5f};  // of the vertex 2, which both faces have
  EXPECT_EQ(make_render_mesh(square(1), 40, even).vertices.size(), 4u);
  const RenderMesh split = make_render_mesh(square(1), 40, seam);
  ASSERT_EQ(split.vertices.size(), 5u);
  for (std::size_t i = 0; i < seam.size(); ++i) EXPECT_EQ(split.texture_coords[split.indices[i]], seam[i]);
  EXPECT_TRUE(make_render_mesh(square(1)).texture_coords.empty());
}

TEST(MeshEdges, FindTwelveCreasesAndSixDiagonalsOfABox) {
  const TriMesh box = make_box({1, 1, 1});
  const auto edges = mesh_edges(box);
  EXPECT_EQ(edges.size(), 18u);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const MeshEdge& e) { return e.crease; }), 12);
  // From a corner three faces are visible, with nine of twelve edges; six of these are outline.
  const VisibleEdges corner = visible_edges(box, edges, {9, 8, 7});
  EXPECT_EQ(corner.outline.size(), 6u);
  EXPECT_EQ(corner.creases.size(), 3u);
  const VisibleEdges front = visible_edges(box, edges, {9, 0, 0});
  EXPECT_EQ(front.outline.size(), 4u);
  EXPECT_EQ(front.creases.size(), 0u);
}

TEST(MeshEdges, TreatAnOpenBorderAsACrease) {
  const TriMesh mesh = square(1);
  const auto edges = mesh_edges(mesh);
  EXPECT_EQ(edges.size(), 5u);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const MeshEdge& e) { return e.right < 0 && e.crease; }), 4);
}

TEST(MeshEdges, OutlineASphereByAClosedLoopNearTheHorizon) {
  const TriMesh sphere = make_icosphere(1, 4);
  const auto edges = mesh_edges(sphere);
  const dvec3 eye(0, 0, 3);
  std::vector<int> touched(static_cast<std::size_t>(sphere.vertex_count()), 0);
  const std::vector<int> outline = visible_edges(sphere, edges, eye).outline;
  ASSERT_GT(outline.size(), 30U);
  for (const int i : outline) {
    const MeshEdge& e = edges[static_cast<std::size_t>(i)];
    ++touched[static_cast<std::size_t>(e.a)];
    ++touched[static_cast<std::size_t>(e.b)];
    EXPECT_NEAR(sphere.vertices()[static_cast<std::size_t>(e.a)].z, 1.0 / 3, 0.1);  // tangent cone: z = r^2 / d
  }
  for (const int count : touched) EXPECT_EQ(count % 2, 0);
}

TEST(FieldRing, IsACircleOnAPlane) {
  const MeshIndex plane(std::make_shared<const TriMesh>(square(1)));
  const dvec3 center(0.1, -0.05, 0.12);
  const double r = std::sqrt(0.3 * 0.3 - 0.12 * 0.12);
  const auto ring = field_ring(plane, center, 0.3, {0, 0, 1}, 45, 2.0);
  EXPECT_NEAR(total_length(ring), 2 * kPi * r, 6e-5 * 2 * kPi * r);  // chords of 2 degrees: 1 - (2 deg)^2 / 24
  for (const RingPiece& piece : ring) {
    EXPECT_NEAR(glm::length(piece.a - center), 0.3, 1e-12);
    EXPECT_NEAR(piece.a.z, 0, 1e-15);
  }
  EXPECT_TRUE(field_ring(plane, {0, 0, 0.31}, 0.3, {0, 0, 1}, 45).empty());
}

TEST(FieldRing, IsAWholeCircleInsideOneFace) {
  const MeshIndex plane(std::make_shared<const TriMesh>(square(1)));
  const auto ring = field_ring(plane, {0.5, -0.5, 0}, 0.1, {0, 0, 1}, 45, 1.0);
  EXPECT_NEAR(total_length(ring), 2 * kPi * 0.1, 1e-4);
  for (const RingPiece& piece : ring) EXPECT_EQ(piece.face, 0);
}

TEST(FieldRing, JoinsToOneLoopOfTheKnownLengthOnASphere) {
  const MeshIndex sphere(std::make_shared<const TriMesh>(make_icosphere(1, 5)));
  const auto ring = field_ring(sphere, {0, 0, 1}, 0.4, {0, 0, 1}, 45, 2.0);
  // |x - (0,0,1)| = r on the unit sphere: z = 1 - r^2 / 2.
  const double z = 1 - 0.5 * 0.4 * 0.4;
  EXPECT_NEAR(total_length(ring), 2 * kPi * std::sqrt(1 - z * z), 0.005);
  for (const RingPiece& piece : ring) {
    const auto follows = [&](const RingPiece& other) { return glm::length(other.a - piece.b) < 1e-9; };
    EXPECT_TRUE(std::any_of(ring.begin(), ring.end(), follows));
  }
}

TEST(FieldRing, StaysOnFacesWithinTheAngle) {
  const MeshIndex box(std::make_shared<const TriMesh>(make_box({0.01, 0.01, 0.01})));
  const auto ring = field_ring(box, {0, 0, 0.01}, 0.012, {0, 0, 2}, 45);  // reaches over the rim
  ASSERT_FALSE(ring.empty());
  for (const RingPiece& piece : ring) {
    EXPECT_GT(box.mesh().face_normals()[static_cast<std::size_t>(piece.face)].z, std::cos(glm::radians(45.0)));
  }
  EXPECT_GT(field_ring(box, {0, 0, 0.01}, 0.012, {0, 0, 1}, 120).size(), ring.size());
}

TEST(FieldRing, IsDrawnForEachSubtaxel) {
  Taxel taxel;
  taxel.subtaxels = {{{-0.5, 0, 0}, {0, 0, 1}, 0.1}, {{0.5, 0, 0}, {0, 0, 1}, 0.2}};
  const auto ring = taxel_rings(MeshIndex(std::make_shared<const TriMesh>(square(1))), taxel, {});
  EXPECT_NEAR(total_length(ring), 2 * kPi * 0.3, 0.003);
}

TEST(Simplify, KeepsTheShapeWithAboutTheRequestedFaceCount) {
  const auto sphere = std::make_shared<const TriMesh>(make_icosphere(0.5, 6));  // 81 920 faces
  const TriMeshPtr coarse = simplify(sphere, 5000);
  EXPECT_GT(coarse->face_count(), 2500);
  EXPECT_LT(coarse->face_count(), 10000);
  EXPECT_NEAR(coarse->volume(), sphere->volume(), 0.02 * sphere->volume());
  const double cell = std::sqrt(2 * sphere->area() / 5000);
  for (const dvec3& v : coarse->vertices()) EXPECT_NEAR(glm::length(v), 0.5, 0.5 * cell);
  for (int f = 0; f < coarse->face_count(); ++f) {  // no face may be reversed
    EXPECT_GT(glm::dot(coarse->face_normals()[static_cast<std::size_t>(f)], coarse->vertex(f, 0)), 0);
  }
}

TEST(Simplify, ReturnsTheMeshIfItWouldVanish) {
  const auto box = std::make_shared<const TriMesh>(make_box({1, 1, 1}));
  EXPECT_EQ(simplify(box, 1), box);
}

TEST(DepthOrder, SortsAllFacesFromBackToFront) {
  const TriMesh sphere = make_icosphere(1, 3);
  std::vector<glm::vec3> centroids;
  std::vector<std::uint32_t> indices, sorted;
  for (int f = 0; f < sphere.face_count(); ++f) {
    centroids.emplace_back((sphere.vertex(f, 0) + sphere.vertex(f, 1) + sphere.vertex(f, 2)) / 3.0);
    for (int k = 0; k < 3; ++k) indices.push_back(static_cast<std::uint32_t>(3 * f + k));
  }
  const glm::vec3 direction = glm::normalize(glm::vec3(1, 2, -1));
  order_back_to_front(centroids, indices, direction, sorted);
  float last = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < sorted.size(); i += 3) {
    const float depth = glm::dot(centroids[sorted[i] / 3], direction);
    EXPECT_LT(depth, last + 2.0f / 4095 + 1e-5f);  // within one step of the counting sort
    last = std::min(last, depth);
    EXPECT_EQ(sorted[i + 2], sorted[i] + 2);  // faces stay whole
  }
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, indices);
}

}  // namespace
}  // namespace taxel::ui
