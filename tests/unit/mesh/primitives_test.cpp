// Primitive shapes: volumes, areas, edge lengths and errors.
#include "core/mesh/make/primitives.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "core/mesh/topology/mesh_check.h"
#include "unit/mesh/dihedral.h"

namespace taxel {
namespace {

double longest_edge(const TriMesh& mesh) {
  double longest = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, glm::distance(mesh.vertex(f, c), mesh.vertex(f, (c + 1) % 3)));
  }
  return longest;
}

double smallest_angle_deg(const TriMesh& mesh) {
  double smallest = kPi;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const dvec3 a = mesh.vertex(f, (c + 1) % 3) - mesh.vertex(f, c),
                  b = mesh.vertex(f, (c + 2) % 3) - mesh.vertex(f, c);
      smallest = std::min(smallest, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
    }
  }
  return smallest * 180 / kPi;
}

void expect_solid(const TriMesh& mesh) {
  EXPECT_TRUE(mesh.closed());
  EXPECT_GT(mesh.volume(), 0);
  EXPECT_EQ(mesh.shell_count(), 1);
  for (const test::InnerEdge& edge : test::inner_edges(mesh))
    EXPECT_GT(edge.angle, -1e-9) << "convex shapes have no valleys";
  for (const Problem& problem : check_mesh(mesh, "")) EXPECT_EQ(problem.code, "mesh_units") << problem.message;
}

/// Expects order 2: two halvings of the edges divide the error by sixteen.
void expect_second_order(const std::function<double(int)>& value, double exact, double tolerance) {
  const double coarse = value(0) - exact, fine = value(2) - exact;
  EXPECT_LT(coarse, 0) << "inscribed";
  EXPECT_NEAR(0.5 * std::log2(coarse / fine), 2, tolerance);
}

TEST(Primitives, GiveAnExactBox) {
  const TriMesh box = make_box({0.5, 1, 2});
  expect_solid(box);
  EXPECT_DOUBLE_EQ(box.volume(), 8);
  EXPECT_DOUBLE_EQ(box.area(), 28);
  EXPECT_EQ(box.face_count(), 12);
}

TEST(Primitives, PutAnIcosphereOnTheSphereWithSecondOrder) {
  const double r = 0.3;
  for (int n = 0; n <= 4; ++n) {
    const TriMesh sphere = make_icosphere(r, n);
    expect_solid(sphere);
    EXPECT_EQ(sphere.face_count(), 20 << (2 * n));
    for (const dvec3& v : sphere.vertices()) EXPECT_NEAR(glm::length(v), r, 1e-15);
  }
  expect_second_order([&](int i) { return make_icosphere(r, 2 + i).volume(); }, 4.0 / 3.0 * kPi * r * r * r, 0.05);
  expect_second_order([&](int i) { return make_icosphere(r, 2 + i).area(); }, 4 * kPi * r * r, 0.05);
}

TEST(Primitives, ConvergeWithSecondOrderForRoundShapes) {
  const double r = 0.1, h = 0.2;
  const auto edge = [](int i) { return 0.02 / (1 << i); };
  expect_second_order([&](int i) { return make_capsule(r, h, edge(i)).volume(); },
                      4.0 / 3.0 * kPi * r * r * r + 2 * h * kPi * r * r, 0.2);
  expect_second_order([&](int i) { return make_capsule(r, h, edge(i)).area(); }, 4 * kPi * r * r + 4 * kPi * r * h,
                      0.2);
  expect_second_order([&](int i) { return make_cylinder(r, h, edge(i)).volume(); }, 2 * h * kPi * r * r, 0.2);
  expect_second_order([&](int i) { return make_cylinder(r, h, edge(i)).area(); }, 4 * kPi * r * h + 2 * kPi * r * r,
                      0.2);
  expect_second_order(
      [&](int i) {
        return make_ellipsoid({0.1, 0.2, 0.3}, 0.1 / (1 << i)).volume();
      },
      4.0 / 3.0 * kPi * 0.1 * 0.2 * 0.3, 0.2);
}

TEST(Primitives, GiveClosedUniformRoundShapesOfTheRequestedEdge) {
  for (const double edge : {0.3, 0.08, 0.03}) {
    const TriMesh sphere = make_sphere(0.1, edge), ellipsoid = make_ellipsoid({0.1, 0.15, 0.2}, edge);
    const TriMesh capsule = make_capsule(0.1, 0.2, edge), cylinder = make_cylinder(0.1, 0.2, edge);
    for (const TriMesh* mesh : {&sphere, &ellipsoid, &capsule, &cylinder}) {
      expect_solid(*mesh);
      EXPECT_LE(longest_edge(*mesh), edge * (1 + 1e-12));
      EXPECT_GT(smallest_angle_deg(*mesh), 20);
    }
    EXPECT_EQ(capsule.bounds().hi.z, 0.1 + 0.2);
    EXPECT_EQ(cylinder.bounds().hi.z, 0.2);
    EXPECT_EQ(cylinder.bounds().lo.z, -0.2);
  }
}

TEST(Primitives, GiveClosedShortAndLongShapes) {
  expect_solid(make_capsule(1, 1e-3, 0.2));
  expect_solid(make_capsule(1e-3, 1, 2e-3));
  expect_solid(make_cylinder(1, 1e-3, 0.2));
  expect_solid(make_cylinder(1e-3, 1, 1e-3));
  expect_solid(make_cylinder(1, 1, 100));
}

TEST(Primitives, GiveRoundShapesOfFewTrianglesForDisplay) {
  const double r = 0.1;
  for (const double h : {0.001, 0.2, 5.0}) {
    const TriMesh capsule = make_drawn_capsule(r, h), cylinder = make_drawn_cylinder(r, h);
    expect_solid(capsule);
    expect_solid(cylinder);
    EXPECT_LT(capsule.face_count(), 1000);
    EXPECT_LT(cylinder.face_count(), 200);
    const double side = 2 * h * kPi * r * r, ends = 4.0 / 3.0 * kPi * r * r * r;
    EXPECT_NEAR(capsule.volume(), side + ends, 0.03 * (side + ends));
    EXPECT_NEAR(cylinder.volume(), side, 0.006 * side);
    EXPECT_EQ(capsule.bounds().hi.z, h + r);
    EXPECT_EQ(cylinder.bounds().lo.z, -h);
    for (const dvec3& v : capsule.vertices())
      EXPECT_NEAR(glm::length(v - dvec3(0, 0, std::clamp(v.z, -h, h))), r, 1e-15);
  }
  const dvec3 axes(0.002, 0.1, 0.05);  // also for a flat body
  const TriMesh ellipsoid = make_drawn_ellipsoid(axes);
  expect_solid(ellipsoid);
  EXPECT_LT(ellipsoid.face_count(), 1000);
  EXPECT_NEAR(ellipsoid.volume(), 4.0 / 3.0 * kPi * axes.x * axes.y * axes.z, 0.03 * ellipsoid.volume());
}

TEST(Primitives, KeepTheCentroidWhenScaledToAVolume) {
  const TriMesh sphere = make_icosphere(2, 2);
  const TriMesh scaled = scaled_to_volume(sphere, 4.0 / 3.0 * kPi * 8);
  EXPECT_NEAR(scaled.volume(), 4.0 / 3.0 * kPi * 8, 1e-12);
  EXPECT_NEAR(glm::distance(scaled.centroid(), sphere.centroid()), 0, 1e-14);
  EXPECT_EQ(scaled.faces(), sphere.faces());
}

TEST(Primitives, RefuseInvalidSizes) {
  EXPECT_THROW(make_box({1, 0, 1}), Error);
  EXPECT_THROW(make_icosphere(-1, 2), Error);
  EXPECT_THROW(make_icosphere(1, 10), Error);
  EXPECT_THROW(make_icosphere(1, -1), Error);
  EXPECT_THROW(make_sphere(1, 0), Error);
  EXPECT_THROW(make_sphere(1, 1e-9), Error);
  EXPECT_THROW(make_sphere(std::numeric_limits<double>::infinity(), 1), Error);
  EXPECT_THROW(make_capsule(1, 0, 0.1), Error);
  EXPECT_THROW(make_cylinder(1, 1, std::nan("")), Error);
  EXPECT_THROW(make_ellipsoid({1, 1, -1}, 0.1), Error);
  EXPECT_THROW(scaled_to_volume(make_box(dvec3(1)), 0), Error);
}

}  // namespace
}  // namespace taxel
