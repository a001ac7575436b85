// Probes pressed onto a flat pad with known forces, and the errors for probes that cannot be pressed.
#include "core/sensor/probe/probe.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/random_pose.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5, kThickness = 1e-3;   // of the pad
constexpr double kStiffness = kModulus / kThickness;  // kappa [Pa/m]
constexpr double kTop = 0.002, kSide = 0.010, kPitch = 0.004;

TriMesh moved(const TriMesh& mesh, const Pose& X) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v = X * v;
  return {std::move(vertices), mesh.faces()};
}

/// A plate with nine taxels on its upper face, taxel 4 in the middle. The whole plate is moved by X.
struct Plate {
  Layout layout;
  TriMeshPtr mesh;
  explicit Plate(const Pose& X = {}) : mesh(std::make_shared<TriMesh>(moved(make_box(dvec3(kSide, kSide, kTop)), X))) {
    layout.mesh.file = "plate";
    layout.sampling.density = 2e6;
    layout.frame = {X.rotate({0, 1, 0}), X.rotate({0, 0, 1})};
    layout.material.modulus = kModulus;
    layout.material.thickness = kThickness;
    for (int k = 0; k < 9; ++k) {
      const dvec3 center(kPitch * (k % 3 - 1), kPitch * (k / 3 - 1), kTop);
      layout.taxels.push_back({k, "", X * center, X.rotate({0, 0, 1}), 0.003, {}});
    }
  }
  [[nodiscard]] SensorModelPtr model() const { return build_sensor_model(layout, mesh, "", "plate"); }
};

Probe probe_at(const ProbeShape& shape, const dvec3& point, double depth) {
  Probe probe;
  probe.shape = shape;
  probe.point = point;
  probe.depth = depth;
  return probe;
}

const dvec3 kMiddle(0, 0, kTop);
const std::vector<ProbeShape> kShapes{ProbeSphere{0.004}, ProbeEdge{0.01, 0.01, 90}, ProbePoint{0.01, 60},
                                      ProbeMesh{std::make_shared<TriMesh>(make_box(dvec3(0.002)))}};

/// F = kappa pi x^2 (R - x/3) (A2 of the validation page).
TEST(Probe, GivesABallTheForceOfTheDisplacedCap) {
  const SensorModelPtr model = Plate().model();
  ProbePress out;
  const double R = 0.004;
  for (const double x : {1e-4, 3e-4, 8e-4}) {
    press(*model, probe_at(ProbeSphere{R}, kMiddle, x), out);
    const double force = kStiffness * kPi * x * x * (R - x / 3);
    EXPECT_NEAR(out.wrench.force.z, -force, 0.01 * force) << x;
    EXPECT_NEAR(glm::length(dvec2(out.wrench.force)), 0, 1e-3 * force) << x;
  }
}

/// F = kappa V for any volume submerged in a linear field (A3).
TEST(Probe, GivesEdgePointAndMeshTheForceOfTheirVolume) {
  const SensorModelPtr model = Plate().model();
  ProbePress out;
  const double x = 6e-4, slope_edge = std::tan(35 * kPi / 180), slope_point = std::tan(25 * kPi / 180);
  const auto force = [&](const ProbeShape& shape) {
    press(*model, probe_at(shape, kMiddle, x), out);
    return -out.wrench.force.z;
  };
  const auto expect = [](double found, double volume) {
    EXPECT_NEAR(found, kStiffness * volume, 1e-9 * kStiffness * volume);
  };
  expect(force(ProbeEdge{0.006, 0.004, 70}), x * x * slope_edge * 0.006);
  expect(force(ProbePoint{0.004, 50}), kPi * slope_point * slope_point * x * x * x / 3);
  expect(force(kShapes[3]), x * 0.004 * 0.004);
}

TEST(Probe, PressesAMeshWithItsLowestPointForAnyOrigin) {
  const SensorModelPtr model = Plate().model();
  ProbePress here, moved_press;
  const TriMesh box = make_box(dvec3(0.002, 0.001, 0.003));
  press(*model, probe_at(ProbeMesh{std::make_shared<TriMesh>(box)}, kMiddle, 5e-4), here);
  const auto away = std::make_shared<TriMesh>(moved(box, {{1, 0, 0, 0}, {0.1, -0.2, 0.3}}));
  press(*model, probe_at(ProbeMesh{away}, kMiddle, 5e-4), moved_press);
  ASSERT_GT(here.surface.area(), 0);
  EXPECT_NEAR(glm::distance(here.wrench.force, moved_press.wrench.force), 0, 1e-9 * glm::length(here.wrench.force));
  EXPECT_NEAR(glm::distance(here.wrench.torque, moved_press.wrench.torque), 0,
              1e-9 * 0.01 * glm::length(here.wrench.force));
}

/// The displayed mesh is at the pressed position: its lowest point is the tip, at the depth.
TEST(Probe, IsDisplayedAtThePressedPosition) {
  const Pose X{glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3))), {0.1, 0.2, -0.3}};
  const SensorModelPtr model = Plate(X).model();
  const dvec3 up = X.rotate({0, 0, 1});
  ProbePress out;
  for (const ProbeShape& shape : kShapes) {
    press(*model, probe_at(shape, X * kMiddle, 5e-4), out);
    double lowest = 1;
    for (const dvec3& v : out.mesh->vertices()) lowest = std::min(lowest, glm::dot(out.X_MG * v - X * kMiddle, up));
    EXPECT_NEAR(lowest, -5e-4, 2e-5) << shape.index();  // a ball's facets exceed it slightly
    const TriMeshPtr drawn = out.mesh;
    press(*model, probe_at(shape, X * kMiddle, 4e-4), out);
    EXPECT_EQ(out.mesh, drawn) << "made once";
  }
}

TEST(Probe, ReadsTheTaxelBelowAPointMost) {
  const SensorModelPtr model = Plate().model();
  ProbePress out;
  for (std::size_t k = 0; k < 9; ++k) {
    press(*model, probe_at(ProbePoint{0.01, 90}, model->layout.taxels[k].center, 8e-4), out);
    const std::vector<double>& values = out.reading.values;
    ASSERT_EQ(values.size(), 9U);
    EXPECT_GT(values[k], 0) << k;
    for (std::size_t other = 0; other < 9; ++other)
      EXPECT_TRUE(other == k || values[other] < values[k]) << k << " " << other;
  }
}

TEST(Probe, ReadsZeroAtDepthZeroAndMoreWithDepth) {
  const SensorModelPtr model = Plate().model();
  for (const ProbeShape& shape : kShapes) {
    ProbePress out;
    double last = 0;
    for (const double depth : {3e-4, 5e-4, 7e-4}) {
      press(*model, probe_at(shape, kMiddle, depth), out);
      EXPECT_GT(out.reading.values[4], last) << shape.index() << " " << depth;
      last = out.reading.values[4];
    }
    press(*model, probe_at(shape, kMiddle, 0), out);
    EXPECT_EQ(out.reading.values, std::vector<double>(9, 0.0)) << shape.index();
    EXPECT_EQ(out.wrench.force, dvec3(0)) << shape.index();
    EXPECT_TRUE(out.surface.empty()) << shape.index();
  }
}

TEST(Probe, GivesTheSameBytesForTheSamePress) {
  const SensorModelPtr model = Plate().model();
  ProbePress kept;
  for (int round = 0; round < 2; ++round) {
    for (const ProbeShape& shape : kShapes) {
      const Probe probe = probe_at(shape, {0.001, -0.002, kTop}, 6e-4);
      ProbePress fresh;
      press(*model, probe, kept);
      press(*model, probe, fresh);
      ASSERT_EQ(kept.surface.vertices.size(), fresh.surface.vertices.size());
      EXPECT_EQ(std::memcmp(kept.surface.vertices.data(), fresh.surface.vertices.data(),
                            fresh.surface.vertices.size() * sizeof(dvec3)),
                0);
      EXPECT_EQ(kept.wrench.force, fresh.wrench.force);
      EXPECT_EQ(kept.reading.values, fresh.reading.values);
      const auto again = [] { return ProbePress::Body{}; };
      EXPECT_NE(kept.bodies.get({shape, probe.material}, again).body, nullptr) << "the body is kept";
    }
  }
  for (const ProbeShape& shape : kShapes) EXPECT_TRUE(kept.bodies.has({shape, Material{}}));
}

TEST(Probe, ReadsTheSameIfMovedWithTheSensor) {
  Plate plate;
  plate.layout.readout.aggregate = Aggregate::force;
  const SensorModelPtr model = plate.model();
  for (int i = 0; i < 5; ++i) {
    const Pose X = random_pose(7, i, 0.05);
    Plate other(X);
    other.layout.readout.aggregate = Aggregate::force;
    const SensorModelPtr turned = other.model();
    for (const ProbeShape& shape : kShapes) {
      ProbePress a, b;
      Probe probe = probe_at(shape, {0.001, -0.002, kTop}, 6e-4);
      probe.direction = dvec3(0.2, 0.1, -1);
      probe.roll_deg = 25;
      press(*model, probe, a);
      probe.point = X * probe.point;
      probe.direction = X.rotate(3.0 * *probe.direction);
      press(*turned, probe, b);
      const double force = glm::length(a.wrench.force);
      ASSERT_GT(force, 0);
      EXPECT_NEAR(glm::distance(X.rotate(a.wrench.force), b.wrench.force), 0, 1e-8 * force);
      for (std::size_t k = 0; k < 9; ++k)
        EXPECT_NEAR(a.reading.values[k], b.reading.values[k], 1e-3 * force)  // within the accuracy of its quadrature
            << shape.index() << " " << k;
    }
  }
}

TEST(Probe, RotatesAnEdgeByRoll) {
  const SensorModelPtr model = Plate().model();  // distal is y: without roll the edge is along y
  ProbePress out;
  Probe probe = probe_at(ProbeEdge{0.012, 0.01, 60}, kMiddle, 6e-4);
  press(*model, probe, out);
  EXPECT_GT(out.reading.values[1], 1.5 * out.reading.values[3]);
  EXPECT_GT(out.reading.values[7], 1.5 * out.reading.values[5]);
  probe.roll_deg = 90;
  press(*model, probe, out);
  EXPECT_GT(out.reading.values[3], 1.5 * out.reading.values[1]);
  EXPECT_GT(out.reading.values[5], 1.5 * out.reading.values[7]);
}

TEST(Probe, PressesAtTheNearestPointOfTheSkin) {
  const SensorModelPtr model = Plate().model();
  ProbePress on, above;
  press(*model, probe_at(ProbeSphere{}, kMiddle, 5e-4), on);
  press(*model, probe_at(ProbeSphere{}, kMiddle + dvec3(0, 0, 0.003), 5e-4), above);
  EXPECT_EQ(on.reading.values, above.reading.values);
  EXPECT_NEAR(glm::distance(on.X_MP.p, kMiddle - dvec3(0, 0, 5e-4)), 0, 1e-15);
}

/// F = pi E x^2 (1 - 2x/(3R)) of a soft ball on a rigid plane (A1).
TEST(Probe, ReadsARigidSensorWithASoftProbe) {
  Plate plate;
  plate.layout.material.modulus = 0;
  const SensorModelPtr model = plate.model();
  ProbePress out;
  const double R = 0.005, x = 5e-4;
  Probe probe = probe_at(ProbeSphere{R}, kMiddle, x);
  EXPECT_EQ(test::complaint_of([&] { press(*model, probe, out); }),
            "probe: modulus must be greater than 0 on a sensor that is rigid itself, is 0");
  probe.material = {FieldKind::medial_axis, 2e5, 0, 0, 0};
  press(*model, probe, out);
  const double force = kPi * 2e5 * x * x * (1 - 2 * x / (3 * R));
  EXPECT_NEAR(out.wrench.force.z, -force, 0.03 * force);
  EXPECT_GT(out.reading.values[4], 0);
}

TEST(Probe, NamesProbesThatCannotBePressed) {
  const SensorModelPtr model = Plate().model();
  ProbePress out;
  press(*model, probe_at(ProbeSphere{}, kMiddle, 5e-4), out);
  const std::vector<double> before = out.reading.values;
  const auto complaint = [&](const auto& change) {
    Probe probe = probe_at(ProbeSphere{}, kMiddle, 5e-4);
    change(probe);
    const std::string said = test::complaint_of([&] { press(*model, probe, out); });
    EXPECT_EQ(out.reading.values, before) << said;
    return said;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint([](Probe& p) { p.depth = -0.001; }), "probe: depth must be 0 or more, is -0.001");
  EXPECT_EQ(complaint([&](Probe& p) { p.depth = nan; }), "probe: depth must be 0 or more, is nan");
  EXPECT_EQ(complaint([&](Probe& p) { p.roll_deg = nan; }), "probe: roll must be a finite angle, is nan");
  EXPECT_EQ(complaint([&](Probe& p) { p.point.y = nan; }), "probe: point must be finite");
  EXPECT_EQ(complaint([](Probe& p) { p.direction = dvec3(0); }),
            "probe: direction must be finite and not zero, is 0, 0, 0");
  EXPECT_EQ(complaint([](Probe& p) { p.direction = dvec3(0, 0, 1); }),
            "probe: direction must lead into the skin, which faces the same way there");
  EXPECT_EQ(complaint([](Probe& p) { p.shape = ProbeSphere{0}; }), "probe: radius must be greater than 0, is 0");
  EXPECT_EQ(complaint([](Probe& p) { p.shape = ProbeEdge{-1, 1, 90}; }), "probe: length must be greater than 0, is -1");
  EXPECT_EQ(complaint([](Probe& p) { p.shape = ProbePoint{0, 90}; }), "probe: height must be greater than 0, is 0");
  EXPECT_EQ(complaint([](Probe& p) {
              p.shape = ProbePoint{0.01, 180};
            }),
            "probe: angle must be greater than 0 and less than 180 degrees, is 180");
  EXPECT_EQ(complaint([](Probe& p) { p.shape = ProbeMesh{}; }), "probe: the mesh has no triangles");
  EXPECT_EQ(complaint([](Probe& p) { p.material.friction = -1; }), "probe: friction must be 0 or more, not -1");
  const TriMesh box = make_box(dvec3(0.002));
  std::vector<ivec3> inverted = box.faces(), open = box.faces();
  for (ivec3& f : inverted) std::swap(f.x, f.y);
  open.pop_back();
  for (const std::vector<ivec3>& faces : {inverted, open}) {  // These meshes are repaired.
    Probe probe = probe_at(ProbeSphere{}, kMiddle, 5e-4);
    probe.shape = ProbeMesh{std::make_shared<TriMesh>(box.vertices(), faces)};
    EXPECT_EQ(test::complaint_of([&] { press(*model, probe, out); }), "accepted");
  }
}

}  // namespace
}  // namespace taxel
