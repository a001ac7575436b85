// EdgeTopology compared with its definition by testing every pair of faces.
#include "core/mesh/tri_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/dihedral.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

/// Returns the faces with the directed edge a -> b, by testing all faces.
std::vector<int> faces_with(const EdgeTopology& edges, int a, int b) {
  std::vector<int> found;
  for (int h = 0; h < edges.half_edge_count(); ++h)
    if (edges.from(h) == a && edges.to(h) == b) found.push_back(h / 3);
  return found;
}

std::vector<int> all_faces_at(const EdgeTopology& edges, int a, int b) {
  std::vector<int> found = faces_with(edges, a, b);
  const std::vector<int> back = faces_with(edges, b, a);
  found.insert(found.end(), back.begin(), back.end());
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> faces_of(std::span<const int> half_edges) {
  std::vector<int> faces;
  for (const int h : half_edges) faces.push_back(h / 3);
  return faces;
}

/// Expects twins exactly at edges with two faces that pass the edge in opposite directions.
void expect_twins(const EdgeTopology& edges) {
  bool is_closed = edges.half_edge_count() > 0;
  for (int h = 0; h < edges.half_edge_count(); ++h) {
    const int a = edges.from(h), b = edges.to(h);
    ASSERT_EQ(a, edges.faces()[static_cast<std::size_t>(h / 3)][h % 3]);
    ASSERT_EQ(b, edges.faces()[static_cast<std::size_t>(h / 3)][(h + 1) % 3]);
    const std::vector<int> along = faces_with(edges, a, b), across = faces_with(edges, b, a);
    const bool is_inner = along.size() == 1 && across.size() == 1;
    is_closed = is_closed && is_inner;
    EXPECT_EQ(edges.face_across(h), is_inner ? across[0] : -1);
    if (edges.twin(h) < 0) continue;
    EXPECT_EQ(edges.twin(edges.twin(h)), h);
    EXPECT_EQ(edges.from(edges.twin(h)), b);
    EXPECT_EQ(edges.to(edges.twin(h)), a);
  }
  EXPECT_EQ(edges.is_closed(), is_closed);
}

/// Expects every edge once, in order, with all its faces, and found by its ends.
void expect_edges(const EdgeTopology& edges, int vertex_count) {
  int number = 0;
  for (int a = 0; a < vertex_count; ++a) {
    for (int b = a + 1; b < vertex_count; ++b) {
      const std::vector<int> faces = all_faces_at(edges, a, b);
      EXPECT_EQ(faces_of(edges.edge_between(b, a)), faces);
      if (faces.empty()) continue;
      ASSERT_LT(number, edges.edge_count());
      const std::span<const int> edge = edges.edge(number++);
      EXPECT_EQ(edges.low(edge[0]), a);
      EXPECT_EQ(edges.high(edge[0]), b);
      EXPECT_EQ(faces_of(edge), faces);
      const bool is_opposite = faces_with(edges, a, b).size() == 1 && faces_with(edges, b, a).size() == 1;
      EXPECT_EQ(edges.kind(edge), faces.size() == 1  ? EdgeKind::boundary
                                  : faces.size() > 2 ? EdgeKind::nonmanifold
                                  : is_opposite      ? EdgeKind::inner
                                                     : EdgeKind::misoriented);
    }
  }
  EXPECT_EQ(edges.edge_count(), number);
}

/// Corners of one fan are connected by twin edges, and no other corner is. Each fan is in counter-clockwise order.
void expect_fans(const EdgeTopology& edges) {
  const VertexFans fans = edges.vertex_fans();
  std::map<int, int> fans_at;  // number of fans at each vertex
  std::set<int> corners;
  for (int fan = 0; fan < fans.count(); ++fan) {
    const std::span<const int> row = fans.corners_of(fan);
    ++fans_at[edges.from(row[0])];
    for (std::size_t i = 0; i < row.size(); ++i) {
      EXPECT_TRUE(corners.insert(row[i]).second);
      EXPECT_EQ(edges.from(row[i]), edges.from(row[0]));
      EXPECT_EQ(fans.fan_of[static_cast<std::size_t>(row[i])], fan);
      const bool is_last = i + 1 == row.size();
      const int next = edges.twin(previous_edge(row[i]));
      EXPECT_TRUE(is_last ? next < 0 || next == row[0] : next == row[i + 1]);
    }
    EXPECT_EQ(edges.twin(row[0]) < 0, edges.twin(previous_edge(row.back())) < 0) << "a row has two ends, a ring none";
  }
  EXPECT_EQ(static_cast<int>(corners.size()), edges.half_edge_count());
  std::vector<int> several;
  for (const auto& [vertex, count] : fans_at)
    if (count > 1) several.push_back(vertex);
  EXPECT_EQ(edges.nonmanifold_vertices(), several);
}

/// Expects each half-edge without a twin in one loop, and each loop to be a closed chain.
void expect_loops(const EdgeTopology& edges) {
  std::set<int> listed;
  const VertexFans fans = edges.vertex_fans();
  int last_first = -1;
  for (const std::vector<int>& loop : edges.boundary_loops()) {
    EXPECT_EQ(loop[0], *std::min_element(loop.begin(), loop.end()));
    EXPECT_GT(loop[0], last_first);
    last_first = loop[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_LT(edges.twin(loop[i]), 0);
      EXPECT_TRUE(listed.insert(loop[i]).second);
      const int next = loop[(i + 1) % loop.size()];
      EXPECT_EQ(edges.to(loop[i]), edges.from(next));
      EXPECT_EQ(fans.fan_of[static_cast<std::size_t>(next_edge(loop[i]))], fans.fan_of[static_cast<std::size_t>(next)]);
    }
  }
  int open = 0;
  for (int h = 0; h < edges.half_edge_count(); ++h) open += edges.twin(h) < 0 ? 1 : 0;
  EXPECT_EQ(static_cast<int>(listed.size()), open);
}

void expect_exact(const EdgeTopology& edges, int vertex_count) {
  expect_twins(edges);
  expect_edges(edges, vertex_count);
  expect_fans(edges);
  expect_loops(edges);
}

void expect_exact(const TriMesh& mesh) {
  expect_exact(mesh.topology(), mesh.vertex_count());
}

TriMesh without_faces(const TriMesh& mesh, const std::set<int>& removed) {
  std::vector<ivec3> faces;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (!removed.contains(f)) faces.push_back(mesh.faces()[static_cast<std::size_t>(f)]);
  return {mesh.vertices(), std::move(faces)};
}

TEST(EdgeTopology, MatchesBruteForceOnAClosedMesh) {
  const TriMesh mesh = test::bumpy_sphere(2);
  expect_exact(mesh);
  const EdgeTopology& edges = mesh.topology();
  EXPECT_TRUE(edges.is_closed());
  EXPECT_EQ(edges.edge_count(), mesh.face_count() * 3 / 2);
  EXPECT_TRUE(edges.boundary_loops().empty());
  for (const EdgeKind kind : {EdgeKind::boundary, EdgeKind::nonmanifold, EdgeKind::misoriented})
    EXPECT_TRUE(edges.edges_of(kind).empty());
  EXPECT_TRUE(edges.nonmanifold_vertices().empty());
}

TEST(EdgeTopology, IsEmptyWithoutFaces) {
  const EdgeTopology none, three_vertices({}, 3);
  for (const EdgeTopology& edges : {none, three_vertices}) {
    EXPECT_EQ(edges.edge_count(), 0);
    EXPECT_EQ(edges.vertex_fans().count(), 0);
    EXPECT_FALSE(edges.is_closed());
    EXPECT_TRUE(edges.edge_between(0, 1).empty());
  }
}

TEST(EdgeTopology, GivesRightAndFlatDihedralAnglesOfABox) {
  int right = 0, flat = 0;
  for (const test::InnerEdge& edge : test::inner_edges(make_box(dvec3(1)))) {
    right += std::abs(edge.angle - kPi / 2) < 1e-12 ? 1 : 0;
    flat += std::abs(edge.angle) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(right, 12);
  EXPECT_EQ(flat, 6);
  for (const test::InnerEdge& edge : test::inner_edges(flipped(make_box(dvec3(1)))))
    EXPECT_LT(edge.angle, 1e-12) << "from inside a box is concave";
}

TEST(EdgeTopology, GivesTheTotalCurvatureOfASphere) {
  // Mean curvature of a convex body as the sum of edge length times dihedral angle / 2: 4 pi r for a sphere of radius
  // r.
  double sum = 0;
  for (const test::InnerEdge& edge : test::inner_edges(make_icosphere(2, 4))) sum += 0.5 * edge.angle * edge.length;
  EXPECT_NEAR(sum / (4 * kPi * 2), 1, 2e-3);
}

TEST(EdgeTopology, GivesCounterClockwiseFansOfASphere) {
  const TriMesh mesh = make_icosphere(1, 2);
  const EdgeTopology& edges = mesh.topology();
  const VertexFans fans = edges.vertex_fans();
  EXPECT_EQ(fans.count(), mesh.vertex_count());
  for (int fan = 0; fan < fans.count(); ++fan) {
    const std::span<const int> row = fans.corners_of(fan);
    ASSERT_GE(row.size(), 5U);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int v = edges.from(row[i]), w = edges.to(row[i]), next = edges.to(row[(i + 1) % row.size()]);
      EXPECT_EQ(faces_with(edges, w, next), faces_with(edges, v, w)) << "v, w[i], w[i + 1] is a face";
    }
  }
}

TEST(EdgeTopology, GivesABoundaryLoopAroundAHole) {
  const TriMesh sphere = make_icosphere(1, 2);
  const ivec3 removed = sphere.faces()[17];
  const TriMesh open = without_faces(sphere, {17});
  expect_exact(open);
  const EdgeTopology& edges = open.topology();
  EXPECT_EQ(edges.edges_of(EdgeKind::boundary).size(), 3U);
  const auto loops = edges.boundary_loops();
  ASSERT_EQ(loops.size(), 1U);
  std::set<std::pair<int, int>> boundary;
  for (const int h : loops[0]) boundary.emplace(edges.from(h), edges.to(h));
  EXPECT_EQ(boundary,
            (std::set<std::pair<int, int>>{{removed.y, removed.x}, {removed.z, removed.y}, {removed.x, removed.z}}));
}

TEST(EdgeTopology, JoinsHolesThatTouchAtAVertexToOneLoop) {
  const TriMesh sphere = make_icosphere(1, 2);
  // Two faces at vertex 0 that share no edge.
  const VertexFans fans = sphere.topology().vertex_fans();
  const std::span<const int> row = fans.corners_of(fans.fan_of[0]);
  const TriMesh open = without_faces(sphere, {row[0] / 3, row[2] / 3});
  expect_exact(open);
  // The two fans at the vertex are separate, and each has one side at either hole.
  const auto loops = open.topology().boundary_loops();
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 6U);
  EXPECT_EQ(open.topology().nonmanifold_vertices().size(), 1U);
}

TEST(EdgeTopology, FindsTheNonManifoldEdgeOfAFin) {
  const TriMesh box = make_box(dvec3(1));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  vertices.emplace_back(3, 3, 3);
  faces.emplace_back(6, 7, 8);  // 6 and 7 share an edge of the box
  const TriMesh mesh(vertices, faces);
  expect_exact(mesh);
  const EdgeTopology& edges = mesh.topology();
  const auto bad = edges.edges_of(EdgeKind::nonmanifold);
  ASSERT_EQ(bad.size(), 1U);
  EXPECT_EQ(edges.low(bad[0][0]), 6);
  EXPECT_EQ(edges.high(bad[0][0]), 7);
  EXPECT_EQ(bad[0].size(), 3U);
  EXPECT_EQ(edges.edges_of(EdgeKind::boundary).size(), 2U) << "the free edges of the fin";
  EXPECT_EQ(edges.nonmanifold_vertices(), (std::vector<int>{6, 7}));
}

TEST(EdgeTopology, FindsTheThreeMisorientedEdgesOfAReversedFace) {
  const TriMesh sphere = make_icosphere(1, 1);
  std::vector<ivec3> faces = sphere.faces();
  std::swap(faces[5].x, faces[5].y);
  const TriMesh mesh(sphere.vertices(), faces);
  expect_exact(mesh);
  const auto bad = mesh.topology().edges_of(EdgeKind::misoriented);
  ASSERT_EQ(bad.size(), 3U);
  for (const auto edge : bad) EXPECT_TRUE(edge[0] / 3 == 5 || edge[1] / 3 == 5);
  EXPECT_TRUE(mesh.topology().edges_of(EdgeKind::nonmanifold).empty());
}

TEST(EdgeTopology, KeepsTheFansOfTetrahedraThatShareAVertex) {
  const std::vector<ivec3> tet{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  std::vector<ivec3> faces = tet;
  const int other[4] = {0, 4, 5, 6};
  for (const ivec3& f : tet) faces.emplace_back(other[f.x], other[f.y], other[f.z]);
  const EdgeTopology edges(faces, 7);
  expect_exact(edges, 7);
  EXPECT_EQ(edges.nonmanifold_vertices(), std::vector<int>{0});
  const VertexFans fans = edges.vertex_fans();
  EXPECT_EQ(fans.count(), 8);
  for (int fan = 0; fan < fans.count(); ++fan) EXPECT_EQ(fans.corners_of(fan).size(), 3U);
  for (int h = 0; h < 12; ++h) EXPECT_LT(edges.face_across(h), 4);
}

TEST(EdgeTopology, MatchesBruteForceOnAnyFaces) {
  // Random faces over few vertices give bad edges of every kind. Faces may repeat.
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::RandomStream random(seed);
    std::vector<ivec3> faces;
    const std::size_t count = seed % 4 == 0 ? 6 : 25;
    while (faces.size() < count) {
      const ivec3 f(random.below(8), random.below(8), random.below(8));
      if (f.x != f.y && f.y != f.z && f.z != f.x) faces.push_back(f);
    }
    expect_exact(EdgeTopology(faces, 8), 8);
  }
}

TEST(EdgeTopology, MatchesBruteForceOnASphereWithRandomHoles) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    test::RandomStream random(seed);
    const TriMesh sphere = make_icosphere(1, 1);
    std::set<int> removed;
    for (int i = 0; i < 12; ++i) removed.insert(random.below(sphere.face_count()));
    expect_exact(without_faces(sphere, removed));
  }
}

}  // namespace
}  // namespace taxel
