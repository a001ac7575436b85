// Decimation and subdivision: numbers of faces, closed shells, and the distance between the surfaces.
#include <gtest/gtest.h>

#include "core/mesh/compare.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/topology/remesh.h"
#include "fixtures/complaint.h"
#include "unit/mesh/dihedral.h"

namespace taxel {
namespace {

TriMeshPtr shared(TriMesh mesh) {
  return std::make_shared<const TriMesh>(std::move(mesh));
}

/// Returns V - E + F.
int euler_characteristic(const TriMesh& mesh) {
  return mesh.vertex_count() - mesh.topology().edge_count() + mesh.face_count();
}

TriMesh without_last_face(const TriMesh& mesh) {
  std::vector<ivec3> faces = mesh.faces();
  faces.pop_back();
  return TriMesh(mesh.vertices(), std::move(faces));
}

TEST(Decimate, ReachesTheNumberOfFacesAndStaysClosed) {
  const TriMeshPtr finger = shared(make_fingertip());
  double last = 0;
  for (const int faces : {1000, 500, 100}) {
    const TriMeshPtr fewer = shared(decimate(*finger, faces));
    EXPECT_LE(fewer->face_count(), faces);
    EXPECT_GE(fewer->face_count(), faces - 2) << "a collapse takes two faces";
    EXPECT_TRUE(fewer->closed());
    EXPECT_EQ(euler_characteristic(*fewer), 2);
    const SurfaceDistance distance = measure_surface_distance(finger, fewer);
    EXPECT_GT(distance.largest, last) << "fewer faces, farther from the surface";
    last = distance.largest;
    EXPECT_NEAR(fewer->volume(), finger->volume(), 0.1 * finger->volume());
  }
  EXPECT_LT(last, 1.5e-3) << "30 mm finger of 100 faces";
}

TEST(Decimate, KeepsFlatFacesExactly) {
  const TriMeshPtr box = shared(make_box({0.01, 0.02, 0.03}));
  const TriMeshPtr fine = shared(subdivide(*box, 3, SubdivisionScheme::midpoint));
  const TriMeshPtr back = shared(decimate(*fine, 12));
  EXPECT_EQ(back->face_count(), 12);
  EXPECT_LT(measure_surface_distance(box, back).largest, 1e-15);
}

TEST(Decimate, KeepsTheRimOfAnOpenMesh) {
  const TriMesh open = without_last_face(make_icosphere(0.01, 3));
  const TriMesh fewer = decimate(open, 200);
  EXPECT_LE(fewer.face_count(), 200);
  const auto rim_length = [](const TriMesh& mesh) {
    double length = 0;
    for (const auto edge : mesh.topology().edges_of(EdgeKind::boundary))
      length += glm::distance(mesh.vertex(edge[0] / 3, edge[0] % 3), mesh.vertex(edge[0] / 3, (edge[0] + 1) % 3));
    return length;
  };
  EXPECT_EQ(fewer.topology().edges_of(EdgeKind::boundary).size(), 3U);
  EXPECT_DOUBLE_EQ(rim_length(fewer), rim_length(open));
}

TEST(Decimate, StopsIfTheTopologyWouldChange) {
  const TriMesh few = decimate(make_box({1, 1, 1}), 1);
  EXPECT_TRUE(few.closed());
  EXPECT_GE(few.face_count(), 4);
}

TEST(Subdivide, KeepsTheSurfaceByMidpoints) {
  const TriMeshPtr finger = shared(make_fingertip());
  const TriMeshPtr fine = shared(subdivide(*finger, 2, SubdivisionScheme::midpoint));
  EXPECT_EQ(fine->face_count(), 16 * finger->face_count());
  EXPECT_TRUE(fine->closed());
  EXPECT_EQ(euler_characteristic(*fine), 2);
  EXPECT_NEAR(fine->volume(), finger->volume(), 1e-12 * finger->volume());
  EXPECT_LT(measure_surface_distance(finger, fine).largest, 1e-15);
}

/// Loop's limit surface of a sphere is smaller and smoother.
TEST(Subdivide, SmoothsByLoop) {
  const TriMesh ball = make_icosphere(1, 1);
  const TriMesh smooth = subdivide(ball, 3, SubdivisionScheme::loop);
  EXPECT_EQ(smooth.face_count(), 64 * ball.face_count());
  EXPECT_TRUE(smooth.closed());
  EXPECT_LT(smooth.volume(), ball.volume());
  const auto sharpest = [](const TriMesh& mesh) {
    double angle = 0;
    for (const test::InnerEdge& edge : test::inner_edges(mesh)) angle = std::max(angle, std::abs(edge.angle));
    return angle;
  };
  EXPECT_LT(sharpest(smooth), 0.25 * sharpest(ball));
}

TEST(Topology, RefusesInvalidRequests) {
  const TriMesh box = make_box({1, 1, 1});
  EXPECT_EQ(test::complaint_of([&] { decimate(box, 12); }), "has 12 faces: it cannot be decimated to 12");
  EXPECT_EQ(test::complaint_of([&] { decimate(box, 0); }), "must be decimated to 1 face or more, asked for are 0");
  EXPECT_EQ(test::complaint_of([&] { subdivide(box, -1, SubdivisionScheme::loop); }),
            "must be subdivided 1 time or more, asked for are -1");
  EXPECT_EQ(test::complaint_of([&] { subdivide(box, 1000000, SubdivisionScheme::loop); }),
            "has 12 faces: subdivided 1000000 times it has more than 4000000");
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  vertices.emplace_back(3, 3, 3);
  const ivec3 first = faces.front();
  faces.emplace_back(first.x, first.y, static_cast<int>(vertices.size()) - 1);
  const std::string fin = test::complaint_of([&] { decimate(TriMesh(vertices, faces), 4); });
  EXPECT_NE(fin.find("must be a manifold: 1 edge with more than two faces"), std::string::npos) << fin;
}

TEST(SurfaceDistance, EqualsTheDistanceOfParallelPlanes) {
  const TriMeshPtr small = shared(make_box({1, 1, 1})), large = shared(make_box({1.1, 1.1, 1.1}));
  const SurfaceDistance apart = measure_surface_distance(small, large);
  EXPECT_NEAR(apart.largest, 0.1 * std::sqrt(3.0), 1e-12) << "corner to corner";
  EXPECT_GT(apart.rms, 0.1);
  EXPECT_LT(apart.rms, 0.12);
}

}  // namespace
}  // namespace taxel
