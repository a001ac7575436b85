// Facets of rigid meshes: which faces form parallelograms, and that no contact depends on it.
#include "core/hydro/kernel/index/wide_tree.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/math.h"
#include "core/hydro/intersect.h"
#include "core/hydro/kernel/workspace.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

using Facet = FacetTree::Facet;

/// Returns an n x m grid of rectangles, each of two triangles, whose diagonals alternate.
TriMesh make_grid(int n, int m, double width, double height) {
  std::vector<dvec3> vertices;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) vertices.emplace_back(i * width, j * height, 0);
  std::vector<ivec3> faces;
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      if ((i + j) % 2 == 0) {
        faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
      } else {
        faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  return {std::move(vertices), std::move(faces)};
}

/// Returns a mesh whose faces share no vertices, so that none has a neighbour.
TriMesh torn(const TriMesh& mesh) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) vertices.push_back(mesh.vertex(f, c));
    faces.emplace_back(3 * f, 3 * f + 1, 3 * f + 2);
  }
  return {std::move(vertices), std::move(faces)};
}

TriMesh moved(const TriMesh& mesh, const Pose& X, bool single_precision) {
  std::vector<dvec3> vertices;
  for (const dvec3& x : mesh.vertices()) vertices.push_back(single_precision ? dvec3(glm::vec3(X * x)) : X * x);
  return {std::move(vertices), mesh.faces()};
}

int count(const FacetTree& tree, int corners) {
  const auto& facets = tree.facets();
  return static_cast<int>(
      std::count_if(facets.begin(), facets.end(), [&](const Facet& facet) { return facet.corners == corners; }));
}

/// Expects that the facets are the faces of the mesh, each once, with their normals and areas.
void expect_whole(const TriMesh& mesh, const char* what) {
  const FacetTree tree(mesh);
  std::vector<int> seen(at(mesh.face_count()), 0);
  double area = 0;
  for (const Facet& facet : tree.facets()) {
    std::array<dvec3, 4> x{};
    for (std::size_t c = 0; c < at(facet.corners); ++c) x[c] = tree.vertices()[at(facet.vertex[c])];
    const dvec3 doubled = glm::cross(x[1] - x[0], x[2] - x[0]);
    EXPECT_GT(glm::dot(doubled, facet.normal), (1 - 1e-12) * glm::length(doubled)) << what;
    EXPECT_EQ(facet.normal, mesh.face_normals()[at(facet.face)]) << what;
    ++seen[at(facet.face)];
    area += 0.5 * glm::length(doubled) * (facet.corners - 2);
    if (facet.corners == 3) continue;
    EXPECT_LT(glm::distance(x[3], x[1] + x[2] - x[0]), 1e-12 * mesh.bounds().diagonal()) << what;
  }
  EXPECT_NEAR(area, mesh.area(), 1e-12 * mesh.area()) << what;
  EXPECT_LE(*std::max_element(seen.begin(), seen.end()), 1) << what;
  EXPECT_EQ(count(tree, 3) + 2 * count(tree, 4), mesh.face_count()) << what;
}

TEST(FacetTree, HasEveryFaceOnce) {
  expect_whole(make_box(dvec3(1, 2, 3)), "box");
  expect_whole(make_cylinder(0.01, 0.02, 0.003), "cylinder");
  expect_whole(make_icosphere(1, 2), "sphere");
  expect_whole(make_fingertip(), "fingertip");
  expect_whole(make_grid(7, 5, 0.3, 0.1), "grid");
  expect_whole(torn(make_box(dvec3(1))), "torn box");
}

TEST(FacetTree, MakesOneFacetOfEachRectangle) {
  EXPECT_EQ(count(FacetTree(make_box(dvec3(1, 2, 3))), 4), 6);
  EXPECT_EQ(count(FacetTree(make_icosphere(1, 2)), 4), 0);
  // In a grid each face forms parallelograms with all three of its neighbours: the rectangles are those without waste.
  const FacetTree grid(make_grid(7, 5, 0.3, 0.1));
  EXPECT_EQ(count(grid, 4), 35);
  for (const Facet& facet : grid.facets()) {
    const auto& x = grid.vertices();
    const dvec3 u = x[at(facet.vertex[1])] - x[at(facet.vertex[0])],
                v = x[at(facet.vertex[2])] - x[at(facet.vertex[0])];
    EXPECT_NEAR(glm::dot(u, v), 0, 1e-15);
  }
}

TEST(FacetTree, JoinsFacesOfSinglePrecision) {
  for (int i = 0; i < 100; ++i) {
    const TriMesh box = moved(make_box(dvec3(0.02, 0.001, 0.03)), random_pose(5, i, 0.05), true);
    EXPECT_EQ(count(FacetTree(box), 4), 6) << i;
  }
}

TEST(FacetTree, LeavesOtherQuadranglesTwoTriangles) {
  const auto facets_with = [](const dvec3& fourth) {
    return count(FacetTree(TriMesh({{0, 0, 0}, {1, 0, 0}, fourth, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}})), 4);
  };
  EXPECT_EQ(facets_with(dvec3(1, 1, 0)), 1);
  EXPECT_EQ(facets_with(dvec3(1, 1, 2e-7)), 1);
  EXPECT_EQ(facets_with(dvec3(1, 1, 1e-6)), 0);
  EXPECT_EQ(facets_with(dvec3(1, 1 + 1e-6, 0)), 0);
}

TEST(FacetTree, JoinsOnlyAcrossAnEdgeOfTwoFacesInTheSameSense) {
  EXPECT_EQ(count(FacetTree(torn(make_box(dvec3(1)))), 4), 0);
  const std::vector<dvec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(count(FacetTree(TriMesh(square, {{0, 1, 2}, {0, 3, 2}})), 4), 0) << "misoriented";
  EXPECT_EQ(count(FacetTree(TriMesh(square, {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}})), 4), 0) << "three faces";
}

/// The contact with each tet, and the whole wrench on the soft body.
struct ContactByTet {
  struct Part {
    double area = 0;
    dvec3 force{0};
  };
  std::map<int, Part> parts;
  Wrench wrench;
};

ContactByTet contact_by_tet(const HydroBody& soft, const TriMesh& rigid, const Pose& X_WR, bool tree_form) {
  const HydroBody other{RigidMesh(std::make_shared<const MeshIndex>(std::make_shared<const TriMesh>(rigid))), {}, ""};
  IntersectWorkspace workspace;
  workspace.kernel->tree_form = tree_form;
  ContactSurface surface;
  intersect(soft, other, Pose{}, X_WR, surface, workspace);
  ContactByTet contact;
  contact.wrench = pressure_wrench(surface);
  for (const ContactPolygon& p : surface.polygons) {
    ContactByTet::Part& part = contact.parts[p.tet];
    part.area += p.area;
    part.force += p.area * p.pressure * p.normal;
  }
  std::erase_if(contact.parts, [](const auto& entry) { return entry.second.area < 1e-15; });
  return contact;
}

constexpr double kSize = 0.01;

void expect_equal(const ContactByTet& found, const ContactByTet& expected) {
  ASSERT_EQ(found.parts.size(), expected.parts.size());
  double pressed = 1e-6;  // the forces on a body that is wholly inside cancel
  for (const auto& [tet, part] : expected.parts) {
    ASSERT_TRUE(found.parts.contains(tet));
    const ContactByTet::Part& other = found.parts.at(tet);
    EXPECT_NEAR(other.area, part.area, 1e-11 * kSize * kSize);
    EXPECT_LT(glm::distance(other.force, part.force), 1e-10 * (glm::length(part.force) + 1e-5));
    pressed += glm::length(part.force);
  }
  EXPECT_LT(glm::distance(found.wrench.force, expected.wrench.force), 1e-12 * pressed);
  EXPECT_LT(glm::distance(found.wrench.torque, expected.wrench.torque), 1e-12 * kSize * pressed);
}

/// A mesh whose faces are torn apart has triangles alone: the oracle.
TEST(Facets, HaveTheContactOfTheirTriangles) {
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(kSize), soft_material(1e5), 0.3 * kSize);
  const auto slab = make_slab(dvec2(2 * kSize), kSize, {4, 4, 2}, 1e7);
  int touching = 0;
  for (const TriMesh& rigid :
       {make_box(kSize * dvec3(1, 0.8, 0.6)), make_box(kSize * dvec3(0.05, 3, 0.4)),
        make_cylinder(0.5 * kSize, kSize, 0.2 * kSize), make_box(kSize * dvec3(0.1, 0.12, 0.08))}) {
    ASSERT_GT(count(FacetTree(rigid), 4), 0);
    const TriMesh triangles = torn(rigid);
    for (const HydroBodyPtr& soft : {sphere, slab}) {
      for (int i = 0; i < 100; ++i) {
        const Pose X = random_pose(9, i, kSize);
        for (const bool tree_form : {false, true}) {
          SCOPED_TRACE(i);
          const ContactByTet found = contact_by_tet(*soft, rigid, X, tree_form);
          expect_equal(found, contact_by_tet(*soft, triangles, X, tree_form));
          touching += found.parts.empty() ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(touching, 800);
}

}  // namespace
}  // namespace taxel
