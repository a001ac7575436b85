// The brush compared with its definition, face by face, and faces that the brush must not reach.
#include "core/mesh/surface_brush.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/rng.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

MeshIndex index_of(TriMesh mesh) {
  return MeshIndex(std::make_shared<TriMesh>(std::move(mesh)));
}

/// Adds neighbours to the face under the brush until no face is added, by testing all faces.
std::vector<int> painted_by_definition(const TriMesh& mesh, const SurfacePoint& at, const SurfaceBrush& brush) {
  const auto reached = [&](int f) {
    const auto i = static_cast<std::size_t>(f);
    const auto start = static_cast<std::size_t>(at.face);
    const double turn =
        glm::degrees(std::acos(glm::clamp(glm::dot(mesh.face_normals()[i], mesh.face_normals()[start]), -1.0, 1.0)));
    const auto nearest = nearest_on_triangle(at.position, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2));
    return turn < brush.max_angle_deg && std::sqrt(nearest.squared_distance) <= brush.radius;
  };
  const auto share_edge = [&](int f, int g) {
    const ivec3 a = mesh.faces()[static_cast<std::size_t>(f)], b = mesh.faces()[static_cast<std::size_t>(g)];
    int common = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) common += a[i] == b[j];
    return common >= 2;
  };
  std::set<int> painted{at.face};
  for (bool grows = true; grows;) {
    grows = false;
    for (int f = 0; f < mesh.face_count(); ++f) {
      if (painted.contains(f) || !reached(f)) continue;
      if (std::any_of(painted.begin(), painted.end(), [&](int g) { return share_edge(f, g); }))
        grows = painted.insert(f).second;
    }
  }
  return {painted.begin(), painted.end()};
}

TEST(SurfaceBrush, PaintsTheFacesOfItsDefinition) {
  const MeshIndex finger = index_of(make_fingertip());
  const CounterRng rng(8);
  for (std::uint64_t i = 0; i < 30; ++i) {
    const dvec3 p(0.03 * rng.uniform(5 * i) - 0.015, 0.03 * rng.uniform(5 * i + 1) - 0.015,
                  0.03 * rng.uniform(5 * i + 2));
    const SurfaceBrush brush{0.004 * rng.uniform(5 * i + 3), 30 + 100 * rng.uniform(5 * i + 4)};
    const SurfacePoint at = finger.closest_point(p);
    const std::vector<int> painted = faces_under_brush(finger, at, brush);
    EXPECT_EQ(painted, painted_by_definition(finger.mesh(), at, brush)) << i;
  }
}

TEST(SurfaceBrush, NeverReachesTheOppositeWall) {
  const MeshIndex plate = index_of(make_box(dvec3(0.01, 0.01, 0.0001)));
  const SurfacePoint at = plate.closest_point({0.001, 0.002, 0.0002});
  const std::vector<int> painted = faces_under_brush(plate, at, {0.005, 90});
  EXPECT_EQ(painted.size(), 2U) << "the two triangles above";
  EXPECT_NEAR(area_of_faces(plate.mesh(), painted), 4e-4, 1e-18);
  EXPECT_EQ(faces_under_brush(plate, at, {1, 180}).size(), 10U) << "180 degrees is not less than 180: all but below";
}

TEST(SurfaceBrush, PaintsOneFaceByADot) {
  const MeshIndex ball = index_of(make_icosphere(0.01, 3));
  const SurfacePoint at = ball.closest_point({0.003, 0.02, 0.001});
  EXPECT_EQ(faces_under_brush(ball, at, {0, 90}), std::vector{at.face});
}

TEST(SurfaceBrush, MakesRegionsThatAreSets) {
  EXPECT_EQ(with_faces({1, 3, 5}, {2, 3}), (std::vector{1, 2, 3, 5}));
  EXPECT_EQ(taxel::without_faces({1, 3, 5}, {2, 3}), (std::vector{1, 5}));
  EXPECT_EQ(area_of_faces(make_box(dvec3(0.5)), {0, 1, 500, -1}), 1);
}

}  // namespace
}  // namespace taxel
