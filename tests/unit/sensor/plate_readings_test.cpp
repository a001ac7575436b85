// Readings that are known on paper, by every method: overlapping subtaxels, walls thinner than twice the rays, and
// normals between those of the faces.
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/query/triangle.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

constexpr double kPlateTop = 0.002, kPlatePressure = 2e4;

/// Returns the layout of a plate of 20 x 20 x 4 mm, without taxels.
Layout layout_of_plate(Aggregate how, ReadingMethod method) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = 2e6;
  layout.readout.aggregate = how;
  layout.readout.method = method;
  layout.readout.max_depth = 0.0035;
  return layout;
}

SensorModelPtr model_of_plate(const Layout& layout) {
  return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
}

/// Returns a horizontal sheet of uniform pressure for x in [from, 1 cm], `depth` below the top, in narrow strips.
ContactSurface pressed_sheet(double from, double depth) {
  ContactSurface surface;
  const double a = 0.01, z = kPlateTop - depth;
  constexpr int kStrips = 40;
  for (int i = 0; i < kStrips; ++i) {
    const double x = from + (a - from) * i / kStrips, next = from + (a - from) * (i + 1) / kStrips;
    add_polygon(surface, {dvec3(x, -a, z), dvec3(next, -a, z), dvec3(next, a, z), dvec3(x, a, z)}, kPlatePressure,
                dvec3(0));
  }
  return surface;
}

std::vector<double> read_all(const SensorModel& model, const ContactSurface& surface) {
  SensorReading reading;
  const ContactSurface* list[] = {&surface};
  read_sensor(model, list, reading);
  return reading.values;
}

double read_exactly(const SensorModel& model, const ContactSurface& surface) {
  const ContactSurface* list[] = {&surface};
  return exact_reading(model, 0, list).value.value();
}

Subtaxel disc_at(double x, double radius) {
  return {dvec3(x, 0, kPlateTop), dvec3(0, 0, 1), radius};
}

/// Returns a taxel at the middle of the top whose field is that of these subtaxels.
Taxel taxel_of(const std::vector<Subtaxel>& subtaxels, double radius) {
  return {0, "", dvec3(0, 0, kPlateTop), dvec3(0, 0, 1), radius, subtaxels};
}

// A field is the union of its subtaxels' discs: two equal subtaxels are as one. So int w p dA = p pi r^4 / 6 and
// int p dA = p pi r^2, the reading weighted_sum is the first one times the samples per area, and each sample is in the
// field once.
TEST(EqualSubtaxels, CountOnceInIntegralsAndSamples) {
  const double r = 0.004, weighted = kPi * std::pow(r, 4) / 6, plain = kPi * r * r;
  const ContactSurface surface = pressed_sheet(-0.01, 0.001);
  const ContactSurface* list[] = {&surface};
  const Taxel twice = taxel_of({disc_at(0, r), disc_at(0, r)}, r);
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    Layout layout = layout_of_plate(how, ReadingMethod::exact);
    layout.taxels = {twice};
    const SensorModelPtr model = model_of_plate(layout);
    const double expected = how == Aggregate::mean ? plain : weighted;
    PressureIntegral integral;
    PressureSums sums;
    integral.integrate(*model->skin_fields, 1, how == Aggregate::weighted_mean, list, {}, sums);
    EXPECT_NEAR(sums.hit[0], expected, 5e-3 * expected) << static_cast<int>(how);
    EXPECT_NEAR(sums.pressure[0], kPlatePressure * expected, 5e-3 * kPlatePressure * expected) << static_cast<int>(how);
    EXPECT_NEAR(model->skin_fields->whole[0], expected, 5e-3 * expected) << static_cast<int>(how);
  }
  Layout layout = layout_of_plate(Aggregate::weighted_sum, ReadingMethod::samples);
  layout.taxels = {twice};
  const SensorModelPtr doubled = model_of_plate(layout);
  layout.taxels = {taxel_of({}, r)};
  const SensorModelPtr single = model_of_plate(layout);
  EXPECT_EQ(doubled->fields.entries.size(), single->fields.entries.size());
  EXPECT_EQ(read_all(*doubled, surface), read_all(*single, surface));
  const double density = static_cast<double>(doubled->samples.size()) / doubled->sampled_area;
  EXPECT_NEAR(read_exactly(*doubled, surface), density * kPlatePressure * weighted,
              2e-3 * density * kPlatePressure * weighted);
}

// Two taxels with equal fields share the force on their disc, whether one of them is made of two equal subtaxels or
// not.
TEST(EqualSubtaxels, GetTheShareOfOneInAForce) {
  const double r = 0.004, half = 0.5 * kPlatePressure * kPi * r * r;
  Layout layout = layout_of_plate(Aggregate::force, ReadingMethod::samples);
  layout.taxels = {taxel_of({disc_at(0, r), disc_at(0, r)}, r), taxel_of({}, r)};
  layout.taxels[1].id = 1;
  for (const double force : read_all(*model_of_plate(layout), pressed_sheet(-0.01, 0.001)))
    EXPECT_NEAR(force, half, 2e-3 * half);
}

// Two discs of radius r at the distance a cover U = 2 pi r^2 - lens. Pressure beyond the line through the second centre
// acts on half of the second disc, pi r^2 / 2, and nowhere else on U: that side of the first disc is in the second one.
// So the mean is p pi r^2 / (2 U), and the force on the taxel is p pi r^2 / 2.
TEST(OverlappingSubtaxels, ReadTheUnionOfTheirDiscs) {
  const double r = 0.004, a = 0.005, side = 0.5 * kPi * r * r;
  const double lens = 2 * r * r * std::acos(a / (2 * r)) - a / 2 * std::sqrt(4 * r * r - a * a);
  const double mean = kPlatePressure * side / (2 * kPi * r * r - lens);
  const ContactSurface surface = pressed_sheet(a / 2, 0.001);
  Layout layout = layout_of_plate(Aggregate::mean, ReadingMethod::exact);
  layout.taxels = {taxel_of({disc_at(-a / 2, r), disc_at(a / 2, r)}, r)};
  const SensorModelPtr exact = model_of_plate(layout);
  EXPECT_NEAR(read_all(*exact, surface)[0], mean, 5e-3 * mean);
  EXPECT_NEAR(read_exactly(*exact, surface), mean, 5e-3 * mean);
  layout.readout.method = ReadingMethod::samples;
  EXPECT_NEAR(read_all(*model_of_plate(layout), surface)[0], mean, 0.05 * mean);
  layout.readout.aggregate = Aggregate::force;
  EXPECT_NEAR(read_all(*model_of_plate(layout), surface)[0], kPlatePressure * side, 5e-3 * kPlatePressure * side);
}

// The weight of a point is that of the nearest subtaxel: at equal radii the larger one. Left and right of the middle
// the weights are mirrored, so that pressure on the right half gives half of the pressure, whichever subtaxel is named
// first. With the weight of the subtaxel that is named last it would be less or more.
TEST(OverlappingSubtaxels, WeighByTheNearestOfThem) {
  const double r = 0.004, a = 0.005;
  const ContactSurface surface = pressed_sheet(0, 0.001);
  for (const double side : {-1.0, 1.0}) {
    Layout layout = layout_of_plate(Aggregate::weighted_mean, ReadingMethod::exact);
    layout.taxels = {taxel_of({disc_at(-side * a / 2, r), disc_at(side * a / 2, r)}, r)};
    const SensorModelPtr model = model_of_plate(layout);
    EXPECT_NEAR(read_all(*model, surface)[0], 0.5 * kPlatePressure, 2e-3 * kPlatePressure) << side;
    EXPECT_NEAR(read_exactly(*model, surface), 0.5 * kPlatePressure, 2e-3 * kPlatePressure) << side;
  }
}

// The plate is 4 mm thick, and rays are at most 3.5 mm long: each ends in the middle of the plate, 2 mm below the top.
// A sheet 1.9 mm below the top is read, and one at 2.1 mm belongs to the other side.
TEST(ThinWall, EndsRaysInItsMiddleForEveryMethod) {
  const double r = 0.004;
  const ContactSurface above = pressed_sheet(-0.01, 0.0019), below = pressed_sheet(-0.01, 0.0021);
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean, Aggregate::max, Aggregate::nearest}) {
    for (const ReadingMethod method : {ReadingMethod::samples, ReadingMethod::exact}) {
      const bool has_integral = how == Aggregate::weighted_mean || how == Aggregate::mean;
      if (method == ReadingMethod::exact && !has_integral) continue;
      Layout layout = layout_of_plate(how, method);
      layout.taxels = {taxel_of({}, r)};
      const SensorModelPtr model = model_of_plate(layout);
      ASSERT_EQ(model->max_depth, 0.0035);
      EXPECT_NEAR(read_all(*model, above)[0], kPlatePressure, 1e-3 * kPlatePressure) << static_cast<int>(how);
      EXPECT_EQ(read_all(*model, below)[0], 0) << static_cast<int>(how);
      EXPECT_NEAR(read_exactly(*model, above), kPlatePressure, 1e-3 * kPlatePressure) << static_cast<int>(how);
      EXPECT_EQ(read_exactly(*model, below), 0) << static_cast<int>(how);
    }
  }
}

/// Returns an octahedron whose corners are at 10 mm on the axes, a sphere of eight faces. The normal of each corner is
/// its axis, and face 0 is that of the positive axes.
TriMeshPtr sphere_of_eight_faces() {
  const double r = 0.010;
  return std::make_shared<const TriMesh>(
      std::vector<dvec3>{{r, 0, 0}, {0, r, 0}, {0, 0, r}, {-r, 0, 0}, {0, -r, 0}, {0, 0, -r}},
      std::vector<ivec3>{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}});
}

// The taxel's normal is (1, 1, 1) / sqrt(3), that of face 0. The interpolated normal is (1, 1, 1) / sqrt(3) in the
// middle of the face, (1, 1, 0) / sqrt(2) in the middle of an edge and (1, 0, 0) in a corner, so the cosines are 1,
// sqrt(2/3) and sqrt(1/3). With a roll-off from 0 to 60 degrees the factor is t^2 (3 - 2t), t = 2 cosine - 1. Normals
// that are not of unit length would be as short as 0.58 in the middle of the face.
TEST(InterpolatedNormals, HaveUnitLengthOnASphereOfEightFaces) {
  const TriMeshPtr mesh = sphere_of_eight_faces();
  const dvec3 a = mesh->vertex(0, 0), b = mesh->vertex(0, 1), middle = (a + b + mesh->vertex(0, 2)) / 3.0;
  Layout layout;
  layout.receptive_field = {Metric::euclidean, 60, 60, FieldNormals::interpolated};
  layout.taxels = {{0, "", middle, dvec3(1, 1, 1), 0.010, {}}};
  const auto weights = std::make_shared<const FieldWeights>(layout, MeshIndex(mesh));
  const FaceFields fields(weights, *mesh);
  const std::vector<int> discs{0};
  for (const auto& [point, cosine] :
       {std::pair(middle, 1.0), std::pair(0.5 * (a + b), std::sqrt(2.0 / 3)), std::pair(a, std::sqrt(1.0 / 3))}) {
    const double t = 2 * cosine - 1, factor = t * t * (3 - 2 * t);
    EXPECT_NEAR(glm::length(skin_normal(*mesh, 0, point)), 1, 1e-12);
    FieldWeights::AtPoint at_point;
    weights->at(0, point, discs, at_point);
    ASSERT_EQ(at_point.weights.size(), 1U) << cosine;
    EXPECT_NEAR(at_point.weights[0].facing, factor, 1e-9) << cosine;
    FaceFields::AtPoint on_face;
    fields.at(0, fields.plane(0).project(point), on_face);
    EXPECT_NEAR(on_face.facing.at(0), factor, 1e-9) << cosine;
  }
}

}  // namespace
}  // namespace taxel
