// Triangles that the kernel clips by the tets of a cube.
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

using Triangle = std::array<dvec3, 3>;

/// Six tets that fill the box [-1, 1]^2 x [-1, 0].
const HydroBody& cube() {
  static const HydroBodyPtr body = make_slab(dvec2(1), 1, ivec3(1), 1, FaceRule::all);
  return *body;
}

ContactSurface clipped(const Triangle& t) {
  const auto mesh =
      std::make_shared<const TriMesh>(std::vector<dvec3>{t[0], t[1], t[2]}, std::vector<ivec3>{{0, 1, 2}});
  const HydroBody rigid{RigidMesh{std::make_shared<const MeshIndex>(mesh)}, {}, "triangle"};
  return touch(cube(), rigid, Pose{}, Pose{}).surface;
}

/// Returns the clipped area, including the part in the skin, where the pressure is zero.
double clipped_area(const Triangle& triangle) {
  const ContactSurface surface = clipped(triangle);
  return surface.area() + surface.left_out(Rejection::touching).area + surface.left_out(Rejection::sliver).area;
}

TEST(Clip, DividesATriangleAmongTetsWithoutLossOrOverlap) {
  const CounterRng rng(3);
  std::uint64_t k = 0;
  for (int i = 0; i < 200; ++i) {
    Triangle triangle;
    for (dvec3& v : triangle) {
      v.x = 2 * rng.uniform(k++) - 1;
      v.y = 2 * rng.uniform(k++) - 1;
      v.z = -rng.uniform(k++);
    }
    const double whole = 0.5 * glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    EXPECT_NEAR(clipped_area(triangle), whole, 1e-13);
  }
}

TEST(Clip, CountsATriangleInASharedPlaneOnce) {
  // x = y is a plane between the tets of the cell.
  EXPECT_NEAR(clipped_area({dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)}), std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(clipped_area({dvec3(-0.5, -0.5, -0.9), dvec3(0.3, 0.3, -0.8), dvec3(0.1, 0.1, -0.2)}),
              0.5 * std::sqrt(2.0) * (0.8 * 0.7 - 0.6 * 0.1), 1e-14);
}

TEST(Clip, AssignsASharedPlaneToTheLowerTet) {
  const PressureField& field = *std::get<SoftBody>(cube().geometry).field;
  const ContactSurface surface = clipped({dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)});
  ASSERT_FALSE(surface.empty());
  for (const ContactPolygon& polygon : surface.polygons) {
    const Tet& tet = field.tets()[static_cast<std::size_t>(polygon.tet)];
    for (int i = 0; i < 4; ++i) {
      const dvec3& n = tet.normal[static_cast<std::size_t>(i)];
      const bool in_plane = std::abs(n.x + n.y) + std::abs(n.z) < 1e-14;  // the plane x = y
      EXPECT_TRUE(!in_plane || tet.neighbour[i] > polygon.tet);
    }
  }
}

TEST(Clip, CountsATriangleOneRoundingOffASharedPlaneOnce) {
  for (const double noise : {1e-17, 1e-16, 3e-16, 1e-15, 1e-12}) {
    for (int corner = 0; corner < 6; ++corner) {
      Triangle triangle{dvec3(-1, -1, -1), dvec3(1, 1, -1), dvec3(1, 1, 0)};
      triangle[static_cast<std::size_t>(corner / 2)].x +=
          (corner % 2 == 0 ? 1 : -1) * noise;  // the triangle's own area changes by the same amount
      EXPECT_NEAR(clipped_area(triangle), std::sqrt(2.0), 1e-13 + noise) << noise << " " << corner;
    }
  }
}

TEST(Clip, KeepsATriangleInTheBoundary) {
  EXPECT_NEAR(clipped_area({dvec3(-1, -1, 0), dvec3(1, -1, 0), dvec3(0, 1, 0)}), 2.0, 1e-14);
}

TEST(Clip, RemovesOutsideAndTouchingTriangles) {
  EXPECT_EQ(clipped_area({dvec3(-1, -1, 1), dvec3(1, -1, 1), dvec3(0, 1, 1)}), 0);
  EXPECT_EQ(clipped_area({dvec3(-1, -1, 0), dvec3(-1, -1, 1), dvec3(1, 1, 1)}), 0);  // a corner touches
}

/// With many corners and clips, the area inside a cube equals that of a grid of points on the triangle (brute force).
TEST(Clip, GivesTheAreaOfThePointsInside) {
  const CounterRng rng(4);
  constexpr int kGrid = 400;
  for (int i = 0; i < 20; ++i) {
    Triangle t;
    for (std::uint64_t c = 0; c < 3; ++c) {
      for (int k = 0; k < 3; ++k)
        t[c][k] = 3 * rng.uniform(static_cast<std::uint64_t>(9 * i + k) + 3 * c) - (k == 2 ? 2.0 : 1.5);
    }
    int inside = 0;
    for (int a = 0; a < kGrid; ++a) {
      for (int b = 0; b < kGrid; ++b) {
        double u = (a + 0.5) / kGrid, v = (b + 0.5) / kGrid;
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const dvec3 x = (1 - u - v) * t[0] + u * t[1] + v * t[2];
        inside += std::abs(x.x) < 1 && std::abs(x.y) < 1 && x.z > -1 && x.z < 0 ? 1 : 0;
      }
    }
    const double whole = 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
    EXPECT_NEAR(clipped_area(t), whole * inside / (kGrid * kGrid), 0.01 * whole) << i;
  }
}

}  // namespace
}  // namespace taxel
