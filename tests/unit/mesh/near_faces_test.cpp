// Nearest points from the faces of cells, compared bit for bit with the search in the tree.
#include "core/mesh/query/nearest.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/counted_new.h"

namespace taxel {
namespace {

class Walk {
 public:
  explicit Walk(const Aabb& box) : box_(box), x_(box.center()) {}
  /// Returns the next point of a random walk in a box somewhat larger than that of a mesh. Some steps are jumps.
  dvec3 next() {
    x_ += 0.01 * box_.diagonal() * (random_vector() - 0.5);
    if (++steps_ % 50 == 0) x_ = box_.center() + 1.3 * (random_vector() - 0.5) * box_.extent();
    return x_;
  }

 private:
  dvec3 random_vector() { return {unit_(random_), unit_(random_), unit_(random_)}; }

  Aabb box_;
  dvec3 x_;
  int steps_ = 0;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> unit_{0, 1};
};

void expect_same(const MeshIndex& index, NearFaces& near, const dvec3& x) {
  const SurfacePoint expected = index.closest_point(x), found = near.closest_point(x);
  ASSERT_EQ(found.face, expected.face) << x.x << ' ' << x.y << ' ' << x.z;
  ASSERT_EQ(found.distance, expected.distance);
  ASSERT_EQ(found.position, expected.position);
  ASSERT_EQ(found.barycentric, expected.barycentric);
}

void expect_same_on_a_walk(const TriMesh& mesh, double edge) {
  const MeshIndex index(std::make_shared<TriMesh>(mesh));
  NearFaces near(index, edge);
  Walk walk(mesh.bounds());
  for (int i = 0; i < 20000; ++i) {
    expect_same(index, near, walk.next());
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(NearFaces, EqualTheSearchInTheTreeOnAFinger) {
  const LoadedMesh finger = load_mesh(TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", dvec3(1));
  for (const double edge : {0.0001, 0.00025, 0.002, 0.1}) expect_same_on_a_walk(*finger.mesh, edge);
}

// From the middle of a box and of a ball, many faces are equally near: ties go to the lowest number. The finest ball
// has more faces than a cell lists, which then uses the tree.
TEST(NearFaces, EqualTheSearchInTheTreeWhereManyFacesAreEquallyNear) {
  for (const TriMesh& mesh : {make_box(dvec3(0.01)), make_icosphere(0.01, 2), make_icosphere(0.01, 4)}) {
    const MeshIndex index(std::make_shared<TriMesh>(mesh));
    NearFaces near(index, 0.001);
    expect_same(index, near, dvec3(0));
    for (const double d : {0.0, 0.003, 0.01, 0.02}) {
      for (const dvec3& x : {dvec3(d), dvec3(d, d, 0), dvec3(0, -d, 0)}) expect_same(index, near, x);
    }
    expect_same_on_a_walk(mesh, 0.001);
  }
}

TEST(NearFaces, EqualTheSearchInTheTreeOnNeedles) {
  // A fan of triangles, of which half are so narrow that rounding decides their normals.
  std::vector<dvec3> vertices{{0, 0, 0}};
  std::vector<ivec3> faces;
  for (int i = 0; i < 40; ++i) {
    vertices.emplace_back(0.02, (i < 20 ? 1e-3 : 1e-12) * i, (i < 20 ? 1e-3 : 1e-12) * (i % 3));
    if (i > 0 && i != 20) faces.emplace_back(0, i, i + 1);
  }
  const MeshIndex index(std::make_shared<TriMesh>(vertices, faces));
  NearFaces near(index, 0.0005);
  Walk walk(index.mesh().bounds());
  for (int i = 0; i < 20000; ++i) {
    expect_same(index, near, walk.next() + dvec3(0, 0, 1e-4));
    if (HasFatalFailure()) return;
  }
}

// The result does not depend on earlier queries, also after cells were forgotten because there were too many.
TEST(NearFaces, EqualTheSearchInTheTreeFarOutsideAndAfterVeryManyCells) {
  const MeshIndex index(std::make_shared<TriMesh>(make_icosphere(0.01, 4)));
  NearFaces near(index, 2e-5);
  Walk walk(index.mesh().bounds());
  for (int i = 0; i < 60000; ++i) {
    const dvec3 x = walk.next();
    const SurfacePoint found = near.closest_point(x);
    if (i % 7 == 0) expect_same(index, near, x);
    ASSERT_GE(found.face, 0);
    if (HasFatalFailure()) return;
  }
  for (const double far : {0.1, 10.0, 1e6}) expect_same(index, near, dvec3(far, -far, 0.3 * far));
}

// 14^3 cells around the middle of a ball list more faces than the memory holds, so all cells are forgotten in between.
TEST(NearFaces, EqualTheSearchInTheTreeAfterTheMemoryOfListsWasFull) {
  const MeshIndex index(std::make_shared<TriMesh>(make_icosphere(0.01, 3)));
  NearFaces near(index, 5e-4);
  const long before = allocation_count();
  for (int i = 0; i < 9 * 14 * 14 * 14; ++i) {
    const int cell = i / 9;
    const dvec3 x = 5e-4 * (dvec3(cell % 14, cell / 14 % 14, cell / 196) + dvec3(0.1 * (i % 9 + 0.5) - 7));
    expect_same(index, near, x);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(allocation_count(), before);
}

TEST(NearFaces, AllocateOnlyInTheConstructor) {
  const MeshIndex index(std::make_shared<TriMesh>(make_icosphere(0.01, 3)));
  NearFaces near(index, 5e-4);
  Walk walk(index.mesh().bounds());
  const long before = allocation_count();
  double sum = 0;
  for (int i = 0; i < 60000; ++i) sum += near.closest_point(walk.next()).distance;
  EXPECT_EQ(allocation_count(), before);
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace taxel
