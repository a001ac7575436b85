#include "core/mesh/topology/halfedge.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

/// Faces that hold the directed edge a -> b, by looking at all.
std::vector<int> faces_with(const TriMesh& mesh, int a, int b) {
  std::vector<int> found;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& ids = mesh.faces()[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c) {
      if (ids[c] == a && ids[(c + 1) % 3] == b) found.push_back(f);
    }
  }
  return found;
}

/// Neighbours and edges by the definition: joined where an edge has two faces that pass it in opposite directions.
void expect_exact(const TriMesh& mesh) {
  const HalfEdges half_edges(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& ids = mesh.faces()[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c) {
      const std::vector<int> along = faces_with(mesh, ids[c], ids[(c + 1) % 3]);
      const std::vector<int> across = faces_with(mesh, ids[(c + 1) % 3], ids[c]);
      EXPECT_EQ(half_edges.neighbour(f, c), along.size() == 1 && across.size() == 1 ? across[0] : -1);
    }
  }
  std::size_t sides = 0;
  for (const MeshEdge& edge : half_edges.edges()) {
    sides += edge.right >= 0 ? 2 : 1;
    const ivec3& ids = mesh.faces()[static_cast<std::size_t>(edge.left)];
    const int corner = ids.x == edge.a ? 0 : ids.y == edge.a ? 1 : 2;
    EXPECT_EQ(ids[(corner + 1) % 3], edge.b);
    EXPECT_EQ(edge.right, half_edges.neighbour(edge.left, corner));
  }
  EXPECT_EQ(sides, 3 * mesh.faces().size());
}

TEST(HalfEdges, NeighboursOfAClosedMeshAreThoseOfBruteForce) {
  const TriMesh mesh = test::bumpy_sphere(2);
  const HalfEdges half_edges(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const ivec3& ids = mesh.faces()[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(faces_with(mesh, ids[(c + 1) % 3], ids[c]), std::vector<int>{half_edges.neighbour(f, c)});
  }
  EXPECT_EQ(half_edges.edges().size(), mesh.faces().size() * 3 / 2);
  EXPECT_TRUE(half_edges.boundary_edges().empty());
  EXPECT_TRUE(half_edges.nonmanifold_edges().empty());
  EXPECT_TRUE(half_edges.misoriented_edges().empty());
  EXPECT_TRUE(half_edges.nonmanifold_vertices().empty());
}

TEST(HalfEdges, DihedralAnglesOfABoxAreRightOrFlat) {
  const HalfEdges outward(make_box(dvec3(1))), inward(flipped(make_box(dvec3(1))));
  int right = 0, flat = 0;
  for (const MeshEdge& edge : outward.edges()) {
    right += std::abs(edge.dihedral - kPi / 2) < 1e-12 ? 1 : 0;
    flat += std::abs(edge.dihedral) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(right, 12);
  EXPECT_EQ(flat, 6);
  for (const MeshEdge& edge : inward.edges()) EXPECT_LT(edge.dihedral, 1e-12) << "from inside a box is concave";
}

TEST(HalfEdges, TotalCurvatureOfAClosedMeshIsThatOfItsShape) {
  // Mean curvature of a convex body as sum of edge length times dihedral angle / 2: 4 pi r for a sphere of radius r.
  const TriMesh sphere = make_icosphere(2, 4);
  const HalfEdges half_edges(sphere);
  double sum = 0;
  for (const MeshEdge& edge : half_edges.edges()) {
    const dvec3 along =
        sphere.vertices()[static_cast<std::size_t>(edge.b)] - sphere.vertices()[static_cast<std::size_t>(edge.a)];
    sum += 0.5 * edge.dihedral * glm::length(along);
  }
  EXPECT_NEAR(sum / (4 * kPi * 2), 1, 2e-3);
}

TEST(HalfEdges, OneRingGoesAroundCounterClockwise) {
  const TriMesh mesh = make_icosphere(1, 2);
  const HalfEdges half_edges(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const std::vector<int>& ring = half_edges.one_ring(v);
    ASSERT_GE(ring.size(), 5U);
    for (std::size_t i = 0; i < ring.size(); ++i)
      EXPECT_EQ(faces_with(mesh, ring[i], ring[(i + 1) % ring.size()]).size(), 1U) << "v, w[i], w[i + 1] is a face";
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::vector<int> faces = faces_with(mesh, v, ring[i]);
      ASSERT_EQ(faces.size(), 1U);
      const ivec3& f = mesh.faces()[static_cast<std::size_t>(faces[0])];
      const int next = ring[(i + 1) % ring.size()];
      EXPECT_TRUE(f.x == next || f.y == next || f.z == next);
    }
  }
}

TEST(HalfEdges, BoundaryRunsAroundTheHole) {
  const TriMesh sphere = make_icosphere(1, 2);
  std::vector<ivec3> faces = sphere.faces();
  const ivec3 gone = faces[17];
  faces.erase(faces.begin() + 17);
  const TriMesh open(sphere.vertices(), faces);
  const HalfEdges half_edges(open);
  const std::set<std::pair<int, int>> boundary(half_edges.boundary_edges().begin(), half_edges.boundary_edges().end());
  EXPECT_EQ(boundary, (std::set<std::pair<int, int>>{{gone.y, gone.x}, {gone.z, gone.y}, {gone.x, gone.z}}));
  int rim = 0;
  for (const MeshEdge& edge : half_edges.edges()) {
    rim += edge.right < 0 ? 1 : 0;
    EXPECT_GE(edge.left, 0);
    if (edge.right < 0) {
      EXPECT_EQ(edge.dihedral, 0);
    }
  }
  EXPECT_EQ(rim, 3);
}

TEST(HalfEdges, AFinOnABoxIsANonManifoldEdge) {
  const TriMesh box = make_box(dvec3(1));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  vertices.emplace_back(3, 3, 3);
  faces.emplace_back(6, 7, 8);  // 6 and 7 share an edge of the box
  const TriMesh mesh(vertices, faces);
  expect_exact(mesh);
  const HalfEdges half_edges(mesh);
  ASSERT_EQ(half_edges.nonmanifold_edges().size(), 1U);
  EXPECT_EQ(half_edges.nonmanifold_edges()[0].a, 6);
  EXPECT_EQ(half_edges.nonmanifold_edges()[0].b, 7);
  EXPECT_EQ(half_edges.nonmanifold_edges()[0].faces.size(), 3U);
  EXPECT_EQ(half_edges.boundary_edges().size(), 2U) << "the free edges of the fin";
  EXPECT_EQ(half_edges.nonmanifold_vertices(), (std::vector<int>{6, 7}));
}

TEST(HalfEdges, ATurnedFaceIsMisorientedOnItsThreeEdges) {
  const TriMesh sphere = make_icosphere(1, 1);
  std::vector<ivec3> faces = sphere.faces();
  std::swap(faces[5].x, faces[5].y);
  const HalfEdges half_edges(TriMesh(sphere.vertices(), faces));
  ASSERT_EQ(half_edges.misoriented_edges().size(), 3U);
  for (const BadEdge& edge : half_edges.misoriented_edges()) EXPECT_TRUE(edge.faces[0] == 5 || edge.faces[1] == 5);
  EXPECT_TRUE(half_edges.nonmanifold_edges().empty());
}

TEST(HalfEdges, TwoTetrahedraTouchingAtAVertexKeepTheirOwnRings) {
  const std::vector<ivec3> tet{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::vector<ivec3> faces = tet;
  const int other[4] = {0, 4, 5, 6};
  for (const ivec3& f : tet) faces.emplace_back(other[f.x], other[f.y], other[f.z]);
  const TriMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, faces);
  const HalfEdges half_edges(mesh);
  EXPECT_EQ(half_edges.nonmanifold_vertices(), std::vector<int>{0});
  EXPECT_EQ(half_edges.one_ring(0).size(), 6U);
  EXPECT_EQ(half_edges.one_ring(1).size(), 3U);
  for (int f = 0; f < 4; ++f) {
    for (int c = 0; c < 3; ++c) EXPECT_LT(half_edges.neighbour(f, c), 4);
  }
}

TEST(HalfEdges, AnySoupOfFacesIsTaken) {
  // Random faces over few vertices: bad edges of every kind.
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::RandomStream random(seed);
    std::vector<dvec3> vertices;
    for (int i = 0; i < 8; ++i) vertices.push_back(random.in_cube(1));
    std::set<std::tuple<int, int, int>> seen;
    std::vector<ivec3> faces;
    while (faces.size() < 25) {
      const ivec3 f(random.below(8), random.below(8), random.below(8));
      if (f.x == f.y || f.y == f.z || f.z == f.x || !seen.insert({f.x, f.y, f.z}).second) continue;
      faces.push_back(f);
    }
    const TriMesh mesh(vertices, faces);
    expect_exact(mesh);
  }
}

}  // namespace
}  // namespace taxel
