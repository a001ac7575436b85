// The limit of a reading for more and more samples: closed forms on a plate, many samples on a finger, and a painted
// region.

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/labelled_case.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

const dvec3 kCenter(0.001, 0.002, 0.002);
constexpr double kRadius = 0.004;
const dvec3 kSlope(1.1e6, -4e5, 0);

/// The surface of p = 2e4 + slope x, one millimetre below the top of a plate of 20 x 20 x 4 mm, for x in [from, 1 cm].
struct PressedPlate {
  SensorModelPtr model;
  ContactSurface surface;
  explicit PressedPlate(Aggregate how, double from = -0.01, Misses misses = Misses::zero) {
    Layout layout;
    layout.mesh.file = "plate";
    layout.sampling.density = 1e6;
    layout.readout.aggregate = how;
    layout.readout.misses = misses;
    layout.readout.max_depth = 0.002;
    layout.taxels = {{7, "", kCenter, dvec3(0, 0, 1), kRadius, {}}};
    model = test::preview_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))));
    const double a = 0.01, z = 0.001;
    add_polygon(surface, {dvec3(from, -a, z), dvec3(a, -a, z), dvec3(a, a, z), dvec3(from, a, z)}, 2e4, kSlope);
  }
  [[nodiscard]] ExactReading read() const {
    const ContactSurface* list[] = {&surface, nullptr};
    return exact_reading(*model, 0, list);
  }
};

double pressure(const dvec3& x) {
  return 2e4 + glm::dot(kSlope, x);
}

// Odd terms cancel over a disc, so means are the pressure at its centre; int w dA = pi r^4 / 6.
TEST(ExactReading, EqualsTheClosedFormForALinearPressure) {
  const double p = pressure(dvec3(kCenter.x, kCenter.y, 0));
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean, Aggregate::nearest}) {
    const ExactReading exact = PressedPlate(how).read();
    ASSERT_TRUE(exact.value.has_value());
    EXPECT_NEAR(*exact.value, p, 1e-3 * p) << static_cast<int>(how);
    EXPECT_LE(std::abs(*exact.value - p), exact.error + 1e-9 * p) << static_cast<int>(how);
  }
  const PressedPlate plate(Aggregate::weighted_sum);
  const double density = static_cast<double>(plate.model->samples.size()) / plate.model->sampled_area;
  const double sum = density * p * kPi * std::pow(kRadius, 4) / 6;
  EXPECT_NEAR(*plate.read().value, sum, 1e-3 * sum);
  const double largest = p + glm::length(kSlope) * kRadius;
  EXPECT_NEAR(*PressedPlate(Aggregate::max).read().value, largest, 2e-3 * largest);
}

// A constant pressure right of the centre gives half of the pressure as the mean, or the whole pressure if misses are
// omitted. For a slope along x, int over the half disc of w x dA = r^5 / 30 int cos = r^5 / 15, over pi r^4 / 12.
TEST(ExactReading, EqualsTheClosedFormForHalfADisc) {
  const double p = pressure(dvec3(kCenter.x, kCenter.y, 0));
  const double moment = kSlope.x * std::pow(kRadius, 5) / 15 / (kPi * std::pow(kRadius, 4) / 6);
  const ExactReading half = PressedPlate(Aggregate::weighted_mean, kCenter.x).read();
  EXPECT_NEAR(*half.value, p / 2 + moment, 1e-3 * p);  // the pressure jumps along a line
  EXPECT_LE(std::abs(*half.value - p / 2 - moment), half.error);
  EXPECT_LE(half.error, 0.02 * p);
  const double hit = *PressedPlate(Aggregate::weighted_mean, kCenter.x, Misses::omit).read().value;
  EXPECT_NEAR(hit, p + 2 * moment, 2e-3 * p);
}

TEST(ExactReading, IsTheSumOfItsPolygonParts) {
  PressedPlate plate(Aggregate::weighted_mean, kCenter.x);
  const double a = 0.01, z = 0.001;
  add_polygon(plate.surface, {dvec3(-a, -a, z), dvec3(kCenter.x, -a, z), dvec3(kCenter.x, a, z), dvec3(-a, a, z)}, 2e4,
              kSlope);
  const ExactReading exact = plate.read();
  ASSERT_EQ(exact.parts.size(), 2u);
  EXPECT_NEAR(exact.parts[0].value + exact.parts[1].value, *exact.value, 1e-9 * *exact.value);
  const double alone = *PressedPlate(Aggregate::weighted_mean, kCenter.x).read().value;
  EXPECT_NEAR(exact.parts[0].value, alone, 2e-3 * alone);
}

TEST(ExactReading, NamesAMissingReadingAndAWrongTaxel) {
  PressedPlate plate(Aggregate::nearest, 0.006, Misses::omit);
  EXPECT_FALSE(plate.read().value.has_value());
  EXPECT_EQ(plate.read().missing, "the ray of the centre misses, and misses are left out");
  const ContactSurface* list[] = {&plate.surface};
  EXPECT_THROW(exact_reading(*plate.model, 1, list), Error);
  EXPECT_THROW(exact_reading(*plate.model, -1, list), Error);
  EXPECT_EQ(*exact_reading(*PressedPlate(Aggregate::mean).model, 0, {}).value, 0.0);
}

// Compares with the readings of many samples on a curved skin, for every aggregate with a limit.
TEST(ExactReading, EqualsTheReadingOfManySamples) {
  const TriMeshPtr mesh = test::egg_mesh();
  for (const bool other_way : {false, true}) {
    Layout layout = test::layout_of(FieldKind::pad, 4e7);
    test::add_taxel(layout, mesh, dvec3(0.006, 0, 0.009), 0.004);
    if (other_way) {
      layout.readout.ray = RayDirection::taxel_normal;
      layout.receptive_field.metric = Metric::geodesic;
      layout.taxels[0].subtaxels = {{layout.taxels[0].center, layout.taxels[0].normal, 0.003},
                                    {dvec3(0.0065, 0, 0.0065), dvec3(1, 0, 0.1), 0.002}};
    }
    test::LabelledCase c;
    c.model = test::preview_model(layout, mesh);
    c.other = test::rigid_ball(0.003);
    const auto step = c.sense(test::tap(mesh, dvec3(0.0065, 0.001, 0.008), 0.003, 0.001));
    const ExactReading exact = exact_reading(*c.model, 0, surface_pointers(step));
    EXPECT_NEAR(*exact.value, step.readings[0], 0.01 * *exact.value) << other_way;
    EXPECT_GT(*exact.value, 100.0);
  }
}

// Interpolated normals are within the limit on parts of faces, also of faces that are turned away themselves.
TEST(ExactReading, EqualsTheReadingOfManySamplesWithInterpolatedNormals) {
  const TriMeshPtr mesh = std::make_shared<TriMesh>(make_icosphere(0.01, 1));
  for (const double falloff : {0.0, 10.0}) {
    Layout layout = test::layout_of(FieldKind::pad, 4e7);
    layout.taxels = {{0, "", mesh->vertex(0, 0), mesh->vertex(0, 0), 0.008, {}}};
    layout.receptive_field = {Metric::euclidean, 25, falloff, FieldNormals::interpolated};
    layout.readout.aggregate = falloff > 0 ? Aggregate::weighted_mean : Aggregate::mean;
    test::LabelledCase c;
    c.model = test::preview_model(layout, mesh);
    c.other = test::rigid_ball(0.012);
    const auto step = c.sense(test::tap(mesh, mesh->vertex(0, 0), 0.012, 0.001));
    const ExactReading exact = exact_reading(*c.model, 0, surface_pointers(step));
    ASSERT_TRUE(exact.value.has_value());
    EXPECT_GT(*exact.value, 100.0);
    EXPECT_NEAR(*exact.value, step.readings[0], 0.01 * *exact.value) << falloff;
  }
}

// If a region is painted, only rays from the region affect the reading.
TEST(ExactReading, UsesOnlyThePaintedRegion) {
  const TriMeshPtr mesh = test::egg_mesh();
  Layout layout = test::layout_of(FieldKind::pad, 4e7);
  test::add_taxel(layout, mesh, dvec3(0.007, 0, 0), 0.004);
  test::LabelledCase c;
  c.other = test::rigid_ball(0.003);
  const Pose pose = test::tap(mesh, dvec3(0.007, 0, 0.0015), 0.003, 0.001);
  c.model = test::preview_model(layout, mesh);
  const auto whole = c.sense(pose);
  std::vector<int> upper;
  for (int f = 0; f < mesh->face_count(); ++f)
    if (mesh->vertex(f, 0).z + mesh->vertex(f, 1).z + mesh->vertex(f, 2).z > 0.003) upper.push_back(f);
  layout.sampling.region = upper;
  c.model = test::preview_model(layout, mesh);
  const auto part = c.sense(pose);
  const ExactReading exact = exact_reading(*c.model, 0, surface_pointers(part));
  EXPECT_NEAR(*exact.value, part.readings[0], 0.01 * *exact.value);
  EXPECT_GT(std::abs(part.readings[0] - whole.readings[0]), 0.1 * whole.readings[0]);
}

}  // namespace
}  // namespace taxel
