// Means as integrals over the contact polygons: closed forms on a plate, the limit of many samples, and properties of
// any contact.
#include "core/sensor/reference/pressure_integral.h"

#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/hydro/intersect.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/reference/moments.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

const dvec3 kPlaceOnPlate(0.001, 0.002, 0.002);
constexpr double kPlateRadius = 0.004;

/// A plate of 20 x 20 x 4 mm with one taxel that reads an integral.
SensorModelPtr plate_model(Aggregate how, Misses misses = Misses::zero) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = 1e5;
  layout.readout.aggregate = how;
  layout.readout.method = ReadingMethod::exact;
  layout.readout.misses = misses;
  layout.readout.max_depth = 0.002;
  layout.taxels = {{7, "", kPlaceOnPlate, dvec3(0, 0, 1), kPlateRadius, {}}};
  return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
}

/// Adds a horizontal surface of the pressure 2e4 + slope x for x in [from, to], divided into parts x parts polygons.
void add_sheet(ContactSurface& surface, double from, double to, double z, const dvec3& slope, int parts,
               bool up = true) {
  const double y = 0.0099;
  const auto corner = [&](int i, int j) { return dvec3(from + (to - from) * i / parts, -y + 2 * y * j / parts, z); };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      std::vector<dvec3> corners{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      if (!up) std::reverse(corners.begin(), corners.end());
      add_polygon(surface, corners, 2e4, slope);
    }
}

double read_one(const SensorModel& model, const ContactSurface& surface) {
  SensorReading reading;
  const ContactSurface* list[] = {&surface, nullptr};
  read_sensor(model, list, reading);
  return reading.values.at(0);
}

// The part of a disc on one side of a line at the distance h from its centre has the area r^2 acos(h/r) - h s and the
// first moment 2/3 s^3, s = sqrt(r^2 - h^2).
TEST(DiscMoments, EqualTheClosedFormForASegment) {
  const double r = 0.7;
  for (const double h : {-0.6, -0.2, 0.0, 0.3, 0.69}) {
    const std::vector<dvec2> half{{h, -3}, {5, -3}, {5, 3}, {h, 3}};
    const DiscMoments m = disc_moments(half, dvec2(0), r);
    const double s = std::sqrt(r * r - h * h);
    EXPECT_NEAR(m.area, r * r * std::acos(h / r) - h * s, 1e-14);
    EXPECT_NEAR(m.first.x, 2.0 / 3 * s * s * s, 1e-14);
    EXPECT_NEAR(m.first.y, 0.0, 1e-14);
  }
}

// Triangles that tile a square add up to it, wherever the disc is.
TEST(DiscMoments, AddUpOverTheTrianglesOfASquare) {
  const std::vector<dvec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const dvec2 inner(0.37, -0.21);
  for (const dvec2 center : {dvec2(0.1, 0.2), dvec2(-0.9, 0.4), dvec2(1.4, 1.2), inner}) {
    const DiscMoments whole = disc_moments(square, center, 0.8);
    DiscMoments sum;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<dvec2, 3> triangle{inner, square[i], square[(i + 1) % 4]};
      const DiscMoments part = disc_moments(triangle, center, 0.8);
      sum.area += part.area, sum.first += part.first;
    }
    EXPECT_NEAR(sum.area, whole.area, 1e-13);
    EXPECT_NEAR(glm::distance(sum.first, whole.first), 0.0, 1e-13);
  }
}

// Odd terms cancel over a disc, so the means of a linear pressure are the pressure at its centre.
TEST(PressureIntegral, ReadsThePressureAtTheCentreForALinearPressure) {
  const dvec3 slope(1.1e6, -4e5, 0);
  const double p = 2e4 + glm::dot(slope, kPlaceOnPlate);
  for (const int parts : {1, 3, 40}) {
    ContactSurface surface;
    add_sheet(surface, -0.0099, 0.0099, 0.001, slope, parts);
    EXPECT_NEAR(read_one(*plate_model(Aggregate::weighted_mean), surface), p, 3e-4 * p) << parts;
    EXPECT_NEAR(read_one(*plate_model(Aggregate::mean), surface), p, 1e-9 * p) << parts;
  }
}

// A constant pressure right of the centre: half of the pressure, or all of it where misses are left out. With a slope
// along x, int over the half disc of w x dA = r^5 / 15, int x dA = 2 r^3 / 3, over int w dA = pi r^4 / 6 and pi r^2.
TEST(PressureIntegral, ReadsHalfADisc) {
  const dvec3 slope(1.1e6, 0, 0);
  const double p = 2e4 + slope.x * kPlaceOnPlate.x, r = kPlateRadius;
  const double weighted = slope.x * std::pow(r, 5) / 15 / (kPi * std::pow(r, 4) / 6);
  const double plain = slope.x * 2 * r / (3 * kPi);
  ContactSurface surface;
  add_sheet(surface, kPlaceOnPlate.x, 0.0099, 0.001, slope, 9);
  EXPECT_NEAR(read_one(*plate_model(Aggregate::weighted_mean), surface), p / 2 + weighted, 5e-4 * p);
  EXPECT_NEAR(read_one(*plate_model(Aggregate::mean), surface), p / 2 + plain, 1e-9 * p);
  EXPECT_NEAR(read_one(*plate_model(Aggregate::weighted_mean, Misses::omit), surface), p + 2 * weighted, 5e-4 * p);
  EXPECT_NEAR(read_one(*plate_model(Aggregate::mean, Misses::omit), surface), p + 2 * plain, 1e-9 * p);
}

// A ray reads the first surface that it meets. The sheet that faces the other way hides the deeper one where it is.
TEST(PressureIntegral, ReadsTheFirstOfTwoSheets) {
  const double p = 2e4, r = kPlateRadius;
  ContactSurface deep;
  add_sheet(deep, -0.0099, 0.0099, 0.0005, dvec3(0), 7);
  ContactSurface both = deep;
  const std::size_t before = both.polygons.size();
  add_sheet(both, kPlaceOnPlate.x, 0.0099, 0.0012, dvec3(0), 5, false);
  for (std::size_t i = before; i < both.polygons.size(); ++i) both.polygons[i].pressure = 0.25 * p;
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    const SensorModelPtr model = plate_model(how);
    EXPECT_NEAR(read_one(*model, deep), p, 3e-4 * p);
    EXPECT_NEAR(read_one(*model, both), 0.625 * p, 5e-4 * p) << r;
  }
}

// Rays end at max_depth = 2 mm, so a sheet below it is not read, and a slanted one only where it is less deep.
TEST(PressureIntegral, EndsAtTheAllowedDepth) {
  const SensorModelPtr model = plate_model(Aggregate::mean);
  ContactSurface below;
  add_sheet(below, -0.0099, 0.0099, -0.0001, dvec3(0), 3);
  EXPECT_EQ(read_one(*model, below), 0.0);
  ContactSurface slanted;
  const double y = 0.0099, x = kPlaceOnPlate.x;
  add_polygon(slanted,
              {dvec3(x - 0.008, -y, -0.001), dvec3(x + 0.008, -y, 0.001), dvec3(x + 0.008, y, 0.001),
               dvec3(x - 0.008, y, -0.001)},
              1e4, dvec3(0));
  EXPECT_NEAR(read_one(*model, slanted), 0.5e4, 1e-6 * 1e4);
}

/// The finger of the project, pressed onto the edge of a box in several directions.
struct ExactFinger {
  SensorModelPtr model;
  std::vector<ContactSurface> surfaces;
  explicit ExactFinger(Aggregate how, const ReceptiveFieldRule& rule = {}, double density = 1e5) {
    static const SensorModelPtr base = load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
    Layout layout = base->layout;
    layout.receptive_field = rule;
    layout.readout.aggregate = how;
    layout.readout.method = ReadingMethod::exact;
    layout.sampling.density = density;
    model = build_sensor_model(layout, base->mesh, "", "finger");
  }
  void press(double along, double turn) {
    const HydroBodyPtr box = make_body({ShapeType::box, dvec3(0.02)}, Material{}, "box");
    const Aabb& bounds = model->mesh->bounds();
    Pose X_WB;
    X_WB.q = glm::angleAxis(turn, dvec3(0, 1, 0));
    X_WB.p = bounds.center() + dvec3(0.001, -0.5 * bounds.extent().y - 0.02 + 0.0012, along);
    IntersectWorkspace workspace;
    intersect(*model->body, *box, Pose{}, X_WB, surfaces.emplace_back(), workspace);
  }
  [[nodiscard]] std::vector<double> read(const ContactSurface& surface) const {
    SensorReading reading;
    const ContactSurface* list[] = {&surface};
    read_sensor(*model, list, reading);
    return reading.values;
  }
};

// The adaptive quadrature on the skin (field_integral.h) casts rays instead of cutting polygons.
TEST(PressureIntegral, EqualsTheAdaptiveIntegralOnAFinger) {
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    ExactFinger f(how);
    for (int i = 0; i < 3; ++i) f.press(0.002 + 0.008 * i, 0.3 * i);
    for (const ContactSurface& surface : f.surfaces) {
      const std::vector<double> values = f.read(surface);
      const double peak = *std::max_element(values.begin(), values.end());
      ASSERT_GT(peak, 100);
      const ContactSurface* list[] = {&surface};
      for (int k = 0; k < 12; ++k) {
        const ExactReading exact = exact_reading(*f.model, k, list);
        EXPECT_NEAR(values[at(k)], *exact.value, 1e-3 * peak + exact.error) << static_cast<int>(how) << " " << k;
      }
    }
  }
}

// Weights that roll off with the angle between the taxel's normal and an interpolated normal of the skin.
TEST(PressureIntegral, EqualsTheAdaptiveIntegralWithARollOff) {
  ReceptiveFieldRule rule;
  rule.max_angle_deg = 50, rule.angle_falloff_deg = 10, rule.normals = FieldNormals::interpolated;
  ExactFinger f(Aggregate::weighted_mean, rule);
  f.press(0.018, 0.2);
  const std::vector<double> values = f.read(f.surfaces[0]);
  const double peak = *std::max_element(values.begin(), values.end());
  const ContactSurface* list[] = {f.surfaces.data()};
  for (int k = 0; k < 12; ++k) {
    const ExactReading exact = exact_reading(*f.model, k, list);
    EXPECT_NEAR(values[at(k)], *exact.value, 1e-3 * peak + exact.error) << k;
  }
}

// The samples' reading tends to the integral: 1e6, 4e6 and 16e6 samples per m^2 with the weights of their areas.
TEST(PressureIntegral, IsTheLimitOfEverMoreSamples) {
  ExactFinger f(Aggregate::weighted_mean);
  f.press(0.018, 0.2);
  const std::vector<double> exact = f.read(f.surfaces[0]);
  const double peak = *std::max_element(exact.begin(), exact.end());
  std::vector<double> errors;
  for (const double density : {1e6, 4e6, 16e6}) {
    Layout layout = f.model->layout;
    layout.readout.method = ReadingMethod::samples;
    layout.sampling.density = density;
    layout.sampling.weights = SampleWeights::voronoi;
    const SensorModelPtr sampled = build_sensor_model(layout, f.model->loaded, "", "finger");
    const double worst = [&] {
      SensorReading reading;
      const ContactSurface* list[] = {f.surfaces.data()};
      read_sensor(*sampled, list, reading);
      double largest = 0;
      for (std::size_t k = 0; k < 12; ++k) largest = std::max(largest, std::abs(reading.values[k] - exact[k]));
      return largest / peak;
    }();
    errors.push_back(worst);
    RecordProperty("error_" + std::to_string(errors.size()), std::to_string(worst));
  }
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[0]);
  EXPECT_LT(errors[2], 4e-3);
}

TEST(PressureIntegral, SlidesWithoutJumps) {
  ReceptiveFieldRule rule;
  rule.angle_falloff_deg = 10, rule.normals = FieldNormals::interpolated;
  ExactFinger f(Aggregate::weighted_mean, rule);
  for (int i = 0; i < 120; ++i) f.press(0.019 + 1e-5 * i, 0.2);
  std::vector<double> peak(12, 0.0), jump(12, 0.0), last;
  for (const ContactSurface& surface : f.surfaces) {
    const std::vector<double> values = f.read(surface);
    for (std::size_t k = 0; k < 12; ++k) {
      peak[k] = std::max(peak[k], values[k]);
      if (!last.empty()) jump[k] = std::max(jump[k], std::abs(values[k] - last[k]));
    }
    last = values;
  }
  const double largest = *std::max_element(peak.begin(), peak.end());
  for (std::size_t k = 0; k < 12; ++k) {
    if (peak[k] < 0.05 * largest) continue;
    EXPECT_LT(jump[k], 0.01 * peak[k]) << k;
  }
}

TEST(PressureIntegral, AllocatesNothingAfterTheFirstStep) {
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    ExactFinger f(how);
    for (int i = 0; i < 3; ++i) f.press(0.018 + 0.001 * i, 0.2);
    SensorReading reading;
    std::vector<const ContactSurface*> all;
    for (const ContactSurface& surface : f.surfaces) all.push_back(&surface);
    read_sensor(*f.model, all, reading);
    const long before = allocation_count();
    for (const ContactSurface* surface : all) read_sensor(*f.model, {&surface, 1}, reading);
    read_sensor(*f.model, all, reading);
    EXPECT_EQ(allocation_count() - before, 0);
  }
}

}  // namespace
}  // namespace taxel
