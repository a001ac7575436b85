// Integrals over receptive fields that are known on paper: centres above the skin, tilted taxels, painted regions, and
// contact in the skin of a rigid sensor.
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/reference/moments.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

constexpr double kHalfHeight = 0.002, kFieldReach = 0.004, kUniform = 2e4;

/// Returns a layout for a plate of 20 x 20 x 4 mm with one taxel at this height above the middle of its top.
Layout layout_on_plate(Aggregate how, double height = 0) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = 1e5;
  layout.readout.aggregate = how;
  layout.readout.method = how == Aggregate::force ? ReadingMethod::samples : ReadingMethod::exact;
  layout.readout.max_depth = 0.0015;
  layout.taxels = {{0, "", dvec3(0, 0, kHalfHeight + height), dvec3(0, 0, 1), kFieldReach, {}}};
  return layout;
}

TriMeshPtr box_plate() {
  return std::make_shared<const TriMesh>(make_box(dvec3(0.010, 0.010, kHalfHeight)));
}

SensorModelPtr plate_with(const Layout& layout) {
  return build_sensor_model(layout, box_plate(), "", "plate");
}

/// Returns a square of uniform pressure, `depth` below the top, over x and y from `from` to `to`.
ContactSurface pressed_square(const dvec2& from, const dvec2& to, double depth) {
  ContactSurface surface;
  const double z = kHalfHeight - depth;
  add_polygon(surface, {dvec3(from, z), dvec3(to.x, from.y, z), dvec3(to, z), dvec3(from.x, to.y, z)}, kUniform,
              dvec3(0));
  return surface;
}

SensorReading read_plate(const SensorModel& model, const ContactSurface& surface) {
  SensorReading reading;
  const ContactSurface* list[] = {&surface};
  read_sensor(model, list, reading);
  return reading;
}

// Distances are straight from the stored centre, also if it is h above the skin. The field is then a disc of radius
// sqrt(r^2 - h^2), and int w dA = 2 pi int_h^r (r - t)^2 t dt = 2 pi [r^2 t^2 / 2 - 2 r t^3 / 3 + t^4 / 4].
TEST(FieldIntegrals, HaveTheDiscOfACentreAboveTheSkin) {
  const double h = 0.001, r = kFieldReach;
  const auto primitive = [&](double t) { return r * r * t * t / 2 - 2 * r * t * t * t / 3 + std::pow(t, 4) / 4; };
  const double weighted = 2 * kPi * (primitive(r) - primitive(h)), plain = kPi * (r * r - h * h);
  const SensorModelPtr with_weights = plate_with(layout_on_plate(Aggregate::weighted_mean, h));
  EXPECT_NEAR(with_weights->skin_fields->whole[0], weighted, 2e-3 * weighted);
  const SensorModelPtr without = plate_with(layout_on_plate(Aggregate::mean, h));
  EXPECT_NEAR(without->skin_fields->whole[0], plain, 1e-9 * plain);
  const ContactSurface all = pressed_square({-0.009, -0.009}, {0.009, 0.009}, 0.001);
  EXPECT_NEAR(read_plate(*without, all).sums.pressure[0], kUniform * plain, 1e-9 * kUniform * plain);
}

// The normal of a taxel leans by 30 degrees. Its field rolls off from 15 to 45 degrees, so the factor of the angle is
// t^2 (3 - 2t) with t = (cos 30 - cos 45)/(cos 15 - cos 45) on the whole top. A force is this fraction of the force on
// the disc, and the rest is not covered. A mean has the factor in both integrals.
TEST(FieldIntegrals, CoverTheFractionOfARollOff) {
  const auto cosine = [](double degrees) { return std::cos(degrees * kPi / 180); };
  const double t = (cosine(30) - cosine(45)) / (cosine(15) - cosine(45)), factor = t * t * (3 - 2 * t);
  const double disc = kUniform * kPi * kFieldReach * kFieldReach, all = kUniform * 0.018 * 0.018;
  const ContactSurface surface = pressed_square({-0.009, -0.009}, {0.009, 0.009}, 0.001);
  for (const Aggregate how : {Aggregate::force, Aggregate::weighted_mean, Aggregate::mean}) {
    Layout layout = layout_on_plate(how);
    layout.taxels[0].normal = dvec3(std::sin(kPi / 6), 0, cosine(30));
    layout.receptive_field.max_angle_deg = 45;
    layout.receptive_field.angle_falloff_deg = 30;
    const SensorReading reading = read_plate(*plate_with(layout), surface);
    if (how != Aggregate::force) {
      EXPECT_NEAR(reading.values[0], kUniform, 1e-3 * kUniform);
      continue;
    }
    EXPECT_NEAR(reading.values[0], factor * disc, 2e-3 * disc);
    EXPECT_NEAR(reading.force.covered, factor * disc, 2e-3 * disc);
    EXPECT_NEAR(reading.force.uncovered, all - factor * disc, 2e-3 * disc);
  }
}

// Of the two triangles of the top, one is painted. Their common edge leads through the centre of the taxel, so half of
// the disc remains, and pressure on the other triangle is not read.
TEST(FieldIntegrals, EndAtThePaintedRegion) {
  const TriMeshPtr mesh = box_plate();
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    Layout layout = layout_on_plate(how);
    const double whole = plate_with(layout)->skin_fields->whole[0];
    std::vector<int> top;
    for (int f = 0; f < mesh->face_count(); ++f)
      if (mesh->face_normals()[at(f)].z > 0.9) top.push_back(f);
    ASSERT_EQ(top.size(), 2U);
    layout.sampling.region = std::vector<int>{top[0]};
    const SensorModelPtr half = plate_with(layout);
    EXPECT_NEAR(half->skin_fields->whole[0], 0.5 * whole, 1e-3 * whole);
    const auto middle = [&](int face) {
      return (mesh->vertex(face, 0) + mesh->vertex(face, 1) + mesh->vertex(face, 2)) / 3.0;
    };
    for (const int face : top) {
      const dvec2 direction(glm::normalize(middle(face))), place = 0.0015 * glm::normalize(direction);
      const double read = read_plate(*half, pressed_square(place - 0.0004, place + 0.0004, 0.001)).values[0];
      EXPECT_EQ(read > 0, face == top[0]) << face;
    }
  }
}

// The contact of a rigid sensor is in its skin, so its rays begin 57 nm outside: 2e-6 of the plate's diagonal of 28.6
// mm. Contact that rounding has put 10 nm outside is read. The rays of a soft sensor begin in the skin.
TEST(FieldIntegrals, ReadContactInTheSkinOfARigidSensor) {
  const ContactSurface outside = pressed_square({-0.009, -0.009}, {0.009, 0.009}, -1e-8);
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    for (const bool is_rigid : {true, false}) {
      Layout layout = layout_on_plate(how);
      if (is_rigid) layout.material.modulus = 0;
      EXPECT_NEAR(read_plate(*plate_with(layout), outside).values[0], is_rigid ? kUniform : 0, 1e-3 * kUniform);
    }
  }
}

// The sensor turns about the y axis through the origin with 0.1 rad/s, so that it moves with 0.1 z along x at the
// height z. A sheet 1 mm below the skin is at z = 1 mm, where the speed is vs = 0.1 mm/s: t = -(2/pi) mu p atan(1) =
// -mu p / 2. In the skin at z = 2 mm it would be 1.4 times as much.
TEST(FieldIntegrals, TakeFrictionAtTheDepthOfTheContact) {
  const double mu = 0.5, friction = 0.5 * mu * kUniform;
  const ContactSurface surface = pressed_square({-0.009, -0.009}, {0.009, 0.009}, 0.001);
  const ContactSurface* list[] = {&surface};
  SurfaceMotion motion;
  motion.properties = {0, mu};
  motion.V = {{0, 0, 0}, {0, 0.1, 0}};
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    Layout layout = layout_on_plate(how);
    layout.readout.shear = true;
    SensorReading reading;
    read_sensor(*plate_with(layout), list, reading, RayPath::fastest, {&motion, 1});
    EXPECT_NEAR(reading.friction.values.at(0).x, -friction, 1e-3 * friction);
    EXPECT_NEAR(reading.friction.values.at(0).y, 0, 1e-9 * friction);
  }
}

// Three points of equal weight have the mean 0 and the given second moments.
TEST(ThreePoints, HaveTheGivenMoments) {
  for (const dvec3& moments :
       {dvec3(1, 0, 1), dvec3(2, 0.5, 3), dvec3(1, -1, 1), dvec3(0, 0, 2), dvec3(4, 0.5, 0.25)}) {
    dvec2 sum(0);
    double uu = 0, uv = 0, vv = 0;
    for (const dvec2& q : three_points(moments.x, moments.y, moments.z)) {
      sum += q;
      uu += q.x * q.x / 3, uv += q.x * q.y / 3, vv += q.y * q.y / 3;
    }
    EXPECT_NEAR(glm::length(sum), 0, 1e-14);
    EXPECT_NEAR(uu, moments.x, 1e-14);
    EXPECT_NEAR(uv, moments.y, 1e-14);
    EXPECT_NEAR(vv, moments.z, 1e-14);
  }
}

}  // namespace
}  // namespace taxel
