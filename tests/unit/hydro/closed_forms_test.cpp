// The contact kernel against closed forms (docs/theory/hydro.md, "Closed forms").
#include <gtest/gtest.h>

#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

/// Relative errors over many directions.
struct Errors {
  double worst = 0, mean = 0;
  int count = 0;
  void add(double found, double expected) {
    const double error = found / expected - 1;
    worst = std::max(worst, std::abs(error));
    mean += (error - mean) / ++count;
  }
};

// A1: soft sphere on a rigid plane at depth x: F = pi E x^2 (1 - 2x/(3R)), a^2 = 2Rx - x^2, p_max = E x/R.
Errors soft_sphere_on_plane(double edge, Errors* area = nullptr, Errors* peak = nullptr) {
  constexpr double R = 0.05, x = 0.05 * R;
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), soft_material(kModulus), edge);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  Errors force;
  for (int i = 0; i < 200; ++i) {
    Pose pose = random_pose(7, i, 0);
    pose.p = dvec3(0, 0, R - x);
    const Contact c = touch(*sphere, *plane, pose, Pose{});
    force.add(pose.rotate(c.wrench.force).z, kPi * kModulus * x * x * (1 - 2 * x / (3 * R)));
    if (area != nullptr) area->add(c.surface.area(), kPi * (2 * R * x - x * x));
    if (peak != nullptr) peak->add(c.surface.max_pressure(), kModulus * x / R);
  }
  return force;
}

TEST(ClosedForms, A1HoldsForASoftSphereInAllDirections) {
  Errors area, peak;
  const Errors force = soft_sphere_on_plane(0, &area, &peak);
  EXPECT_LT(force.worst, 0.01);  // measured: 0.0065 with 1280 tets
  EXPECT_LT(std::abs(force.mean), 0.001);
  EXPECT_LT(area.worst, 0.02);
  EXPECT_LT(std::abs(area.mean), 0.001);
  EXPECT_LT(peak.worst, 0.15);
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(0.05, 0, 0), soft_material(kModulus));
  EXPECT_LE(std::get<SoftBody>(sphere->geometry).field->report().tets, 2100);
}

TEST(ClosedForms, A1ConvergesWithTheSquareOfTheEdge) {
  const double coarse = soft_sphere_on_plane(0.008).worst,
               fine = soft_sphere_on_plane(0.002).worst;  // a mesh 4 times as fine
  EXPECT_GT(std::log2(coarse / fine) / 2, 1.8);
}

// A2: rigid sphere in a soft half-space, kappa = E/H: F = kappa pi x^2 (R - x/3), area 2 pi R x.
TEST(ClosedForms, A2HoldsForARigidSphereInASoftHalfSpace) {
  constexpr double R = 0.05, x = 0.1 * R, H = 0.01, kappa = kModulus / H;
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0));
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0), soft_material(kModulus, H));
  Errors force, area;
  for (int i = 0; i < 200; ++i) {
    Pose pose = random_pose(8, i, 0);
    pose.p = dvec3(0.3, -0.2, R - x);
    const Contact c = touch(*plane, *sphere, Pose{}, pose);
    force.add(-c.wrench.force.z, kappa * kPi * x * x * (R - x / 3));
    area.add(c.surface.area(), 2 * kPi * R * x);
  }
  EXPECT_LT(force.worst, 0.01);
  EXPECT_LT(area.worst, 0.01);
}

// A3: any closed rigid polyhedron in a linear field: F = kappa V through the centroid of V. The result is exact.
void expect_buoyancy(const HydroBody& soft, const TriMesh& mesh, const Pose& X_SR, double kappa) {
  HydroBody rigid;
  rigid.geometry = RigidMesh{std::make_shared<const MeshIndex>(std::make_shared<const TriMesh>(mesh))};
  const Contact c = touch(soft, rigid, Pose{}, X_SR);
  const dvec3 force(0, 0, -kappa * mesh.volume());  // on the soft body: the gradient of p points down
  const dvec3 torque = glm::cross(X_SR * mesh.centroid(), force);
  double scale = 0;
  for (const ContactPolygon& p : c.surface.polygons) scale += p.area * p.pressure;
  EXPECT_LE(glm::distance(c.wrench.force, force), 1e-10 * scale);
  EXPECT_LE(glm::distance(c.wrench.torque, torque), 1e-10 * scale * 0.01);
  EXPECT_NEAR(c.surface.area(), mesh.area(), 1e-10 * mesh.area());
  for (const RejectedPolygons& r : c.surface.rejected) EXPECT_LE(r.area, 1e-12 * mesh.area());
}

TEST(ClosedForms, A3HoldsForSunkenPolyhedra) {
  constexpr double kappa = 1e7, size = 0.005;
  const auto half_space =
      make_simple_body(ShapeType::plane, dvec3(0), all_faces(soft_material(kModulus, kModulus / kappa)));
  const auto slab = make_slab(dvec2(0.03), 0.06, {7, 6, 9}, kappa, FaceRule::all);
  const std::vector<TriMesh> meshes{make_box(size * dvec3(1, 0.7, 0.4)), make_icosphere(size, 2),
                                    make_capsule(0.5 * size, size, 0.5 * size), make_fingertip()};
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    for (int i = 0; i < 10; ++i) {
      Pose pose = random_pose(20 + m, i, 0.5 * size);
      pose.p -= pose.rotate(meshes[m].centroid()) + dvec3(0, 0, 0.03);
      SCOPED_TRACE(testing::Message() << "mesh " << m << " pose " << i);
      expect_buoyancy(*half_space, meshes[m], pose, kappa);
      expect_buoyancy(*slab, meshes[m], pose, kappa);
    }
  }
}

TEST(ClosedForms, A3HoldsForTheLowerHalfOfAHalfSunkenBox) {
  constexpr double kappa = 1e7, x = 0.004;
  const dvec3 half(0.01, 0.02, 0.03);
  const auto box = make_simple_body(ShapeType::box, half);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0), soft_material(kModulus, kModulus / kappa));
  const Contact c = touch(*box, *plane, at_height(half.z - x), Pose{});
  const double force = kappa * 4 * half.x * half.y * x;
  EXPECT_NEAR(c.wrench.force.z, force, 1e-10 * force);
  EXPECT_LE(glm::length(c.wrench.torque), 1e-10 * force * half.z);
}

// A8 with a rigid second slab: p = E x/H everywhere.
TEST(ClosedForms, A8HoldsForASlabUnderARigidPlane) {
  constexpr double kappa = 2e7, x = 0.0013;
  const auto slab = make_slab({0.02, 0.03}, 0.01, {5, 4, 3}, kappa);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  const Pose on_top{dquat(0, 1, 0, 0), dvec3(0.4, 0.2, -x)};  // upside down: the rigid side is above
  const Contact c = touch(*slab, *plane, Pose{}, on_top);
  const double area = 4 * 0.02 * 0.03;
  EXPECT_NEAR(c.surface.area(), area, 1e-12 * area);
  EXPECT_NEAR(c.wrench.force.z, -kappa * x * area, 1e-12 * kappa * x * area);
  for (const double p : c.surface.pressure) EXPECT_NEAR(p, kappa * x, 1e-12 * kappa * x);
}

}  // namespace
}  // namespace taxel
