// The friction on a taxel: its tangent frame, Coulomb's law, and the weights of the reading.
#include <gtest/gtest.h>

#include "core/hydro/intersect.h"
#include "core/layout/sensor_frame.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

constexpr Aggregate kAll[] = {Aggregate::weighted_mean, Aggregate::weighted_sum, Aggregate::mean,
                              Aggregate::nearest,       Aggregate::max,          Aggregate::force};

/// Returns a plate of 20 x 20 x 4 mm with two taxels on top, which reads shear.
SensorModelPtr plate(Aggregate how, bool shear = true) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = 1e6;
  layout.frame.distal = dvec3(0.6, 0.8, 0);
  layout.frame.pad = dvec3(0, 0, 1);
  layout.readout.aggregate = how;
  layout.readout.shear = shear;
  layout.taxels = {{4, "", dvec3(-0.003, 0, 0.002), dvec3(0, 0, 2), 0.005, {}},
                   {9, "", dvec3(0.003, 0.001, 0.002), dvec3(0, 0, 1), 0.004, {}}};
  return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
}

ContactSurface patch(double base, const dvec3& slope) {
  ContactSurface surface;
  const double y = 0.0089, z = 0.001;
  add_polygon(surface, {dvec3(-y, y, z), dvec3(y, y, z), dvec3(y, -y, z), dvec3(-y, -y, z)}, base, slope);
  return surface;  // the normal points down, because the surface pushes the plate
}

TEST(TangentFrame, IsRightHandedAndFollowsDistal) {
  const SensorFrame finger{dvec3(0, 0, 1), dvec3(0, -1, 0)};
  const CounterRng rng(3);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const dvec3 n = 3.0 * dvec3(rng.uniform(3 * i) - 0.5, rng.uniform(3 * i + 1) - 0.5, rng.uniform(3 * i + 2) - 0.5);
    const TangentFrame frame = tangent_frame(finger, n);
    EXPECT_NEAR(glm::length(frame.e1), 1, 1e-14);
    EXPECT_LT(glm::distance(glm::cross(frame.e1, frame.e2), glm::normalize(n)), 1e-14);
    const double steep = std::abs(n.z) / glm::length(n);
    if (steep < std::sqrt(1 - 0.0101)) {
      EXPECT_GT(frame.e1.z, 0.099);
    }
  }
  EXPECT_EQ(tangent_frame(finger, dvec3(0, -1, 0)).e1, dvec3(0, 0, 1));
  EXPECT_EQ(tangent_frame(finger, dvec3(0, 0, 5)).e1, dvec3(0, 1, 0)) << "at the tip: away from the pad side";
  EXPECT_EQ(tangent_frame(finger, dvec3(0, 0, 5)).e2, dvec3(-1, 0, 0));
}

// Regularised Coulomb friction: for any aggregate, shear over reading is (2/pi) mu atan(v/vs), against the velocity.
TEST(Shear, IsTheFrictionCoefficientTimesTheReading) {
  const ContactSurface surface = patch(2e4, dvec3(1e5, 2e5, 0));
  const ContactSurface* list[] = {&surface};
  const double mu = 0.4;
  for (const Aggregate how : kAll) {
    const SensorModelPtr model = plate(how);
    for (const double speed : {1e-5, 1e-4, 0.02}) {
      // The sensor slides along -e1 rotated by 30 degrees toward e2, e2 = n x e1 = (-0.8, 0.6, 0).
      const dvec3 e1(0.6, 0.8, 0), e2(-0.8, 0.6, 0);
      const dvec3 v = -speed * (std::cos(kPi / 6) * e1 + std::sin(kPi / 6) * e2);
      const SurfaceMotion motions[] = {{{0, mu}, {v, dvec3(0)}}};
      SensorReading reading;
      read_sensor(*model, list, reading, RayPath::tet_table, motions);
      ASSERT_EQ(reading.shear.size(), 2U);
      for (std::size_t k = 0; k < 2; ++k) {
        const double shear = reading.values[k] * 2 / kPi * mu * std::atan(speed / kSlipSpeed);
        EXPECT_GT(shear, 0);
        EXPECT_NEAR(reading.shear[k].x, shear * std::cos(kPi / 6), 1e-9 * shear) << static_cast<int>(how);
        EXPECT_NEAR(reading.shear[k].y, shear * std::sin(kPi / 6), 1e-9 * shear) << static_cast<int>(how);
      }
    }
  }
}

// Hunt-Crossley: approaching raises the friction by 1 + d v, separating lowers it to zero; the reading stays p0.
TEST(Shear, FollowsTheDampedPressure) {
  const ContactSurface surface = patch(2e4, dvec3(0));
  const ContactSurface* list[] = {&surface};
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::force}) {
    const SensorModelPtr model = plate(how);
    const auto shear = [&](double up) {
      const SurfaceMotion motions[] = {{{5.0, 0.4}, {dvec3(0.01, 0, up), dvec3(0)}}};
      SensorReading reading;
      read_sensor(*model, list, reading, RayPath::tet_table, motions);
      return glm::length(reading.shear[0]);
    };
    EXPECT_NEAR(shear(0.02) / shear(0), 1.1, 1e-9);  // the sensor rises against the body that pushes it down
    EXPECT_EQ(shear(-0.3), 0.0);
  }
}

// A rotation about the axis through the plate's centre slides each taxel across its radius.
TEST(Shear, IsPerpendicularToTheRadiusOfARotation) {
  const ContactSurface surface = patch(2e4, dvec3(0));
  const ContactSurface* list[] = {&surface};
  const SensorModelPtr model = plate(Aggregate::nearest);
  const SurfaceMotion motions[] = {{{0, 0.4}, {dvec3(0), dvec3(0, 0, 10)}}};
  SensorReading reading;
  read_sensor(*model, list, reading, RayPath::tet_table, motions);
  for (std::size_t k = 0; k < 2; ++k) {
    const SensorRay& ray = model->rays[static_cast<std::size_t>(model->readout_table.nearest[k])];
    const dvec3 expected = -glm::normalize(glm::cross(dvec3(0, 0, 10), ray.origin));
    const dvec3 t = reading.shear[k].x * dvec3(0.6, 0.8, 0) + reading.shear[k].y * dvec3(-0.8, 0.6, 0);
    EXPECT_LT(glm::distance(glm::normalize(t), expected), 1e-9);
    EXPECT_NEAR(glm::length(t) / reading.values[k],
                2 / kPi * 0.4 * std::atan(10 * glm::length(dvec2(ray.origin)) / kSlipSpeed), 1e-9);
  }
}

/// The finger of the project on a box.
struct Finger {
  SensorModelPtr model;
  ContactSurface surface;
  SurfaceMotion motion{{2.0, 0.5}, {dvec3(0.003, 0.001, -0.002), dvec3(0.5, 2.0, -1.0)}};
  explicit Finger(Aggregate how, Misses misses = Misses::zero, bool shear = true) {
    static const SensorModelPtr base = load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
    Layout layout = base->layout;
    layout.readout.aggregate = how;
    layout.readout.misses = misses;
    layout.readout.shear = shear;
    layout.sampling.density = 1e6;
    model = build_sensor_model(layout, base->mesh, "", "finger");
    const HydroBodyPtr box = make_body({ShapeType::box, dvec3(0.02)}, Material{}, "box");
    const Aabb& bounds = model->mesh->bounds();
    Pose X_WB;
    X_WB.p = bounds.center() + dvec3(0.001, -0.5 * bounds.extent().y - 0.02 + 0.0012, 0.018);
    IntersectWorkspace workspace;
    intersect(*model->body, *box, Pose{}, X_WB, surface, workspace);
  }
};

/// Computes the traction at the hit of a ray by the law.
dvec3 traction_at(const Finger& f, const RayHit& hit, const SensorRay& ray) {
  if (!hit.hit()) return dvec3(0);
  const dvec3 x = ray.origin + hit.depth * ray.direction;
  const dvec3 n = f.surface.polygons[static_cast<std::size_t>(hit.polygon)].normal;
  const dvec3 v = f.motion.V.linear + glm::cross(f.motion.V.angular, x), vt = v - glm::dot(v, n) * n;
  const double p = hit.pressure * std::max(0.0, 1 - f.motion.properties.dissipation * glm::dot(v, n));
  return -2 / kPi * f.motion.properties.friction * p * std::atan(glm::length(vt) / kSlipSpeed) * glm::normalize(vt);
}

dvec3 expected_friction(const Finger& f, const RayHits& hits, Aggregate how, std::size_t k) {
  dvec3 weighted(0), plain(0), nearest(0), largest(0);
  double w = 0, n = 0, distance = 1e9, pressure = 0;
  const bool omit = f.model->layout.readout.misses == Misses::omit;
  for (int e = f.model->fields.first[k]; e < f.model->fields.first[k + 1]; ++e) {
    const ReceptiveFields::Entry& entry = f.model->fields.entries[static_cast<std::size_t>(e)];
    const int ray = f.model->readout_table.ray_of_entry[static_cast<std::size_t>(e)];
    const RayHit& hit = hits[ray];
    if (omit && !hit.hit()) continue;
    const dvec3 t = traction_at(f, hit, f.model->rays[static_cast<std::size_t>(ray)]);
    weighted += entry.weight * t, w += entry.weight, plain += t, n += 1;
    if (entry.distance < distance) distance = entry.distance, nearest = t;
    if (hit.pressure > pressure) pressure = hit.pressure, largest = t;
  }
  switch (how) {
    case Aggregate::weighted_mean:
      return w > 0 ? weighted / w : dvec3(0);
    case Aggregate::weighted_sum:
      return weighted;
    case Aggregate::mean:
      return n > 0 ? plain / n : dvec3(0);
    case Aggregate::nearest:
      return nearest;
    default:
      return largest;
  }
}

TEST(Shear, EqualsItsDefinitionForEveryAggregateOfRays) {
  for (const Misses misses : {Misses::zero, Misses::omit}) {
    for (const Aggregate how : kAll) {
      if (how == Aggregate::force) continue;
      const Finger f(how, misses);
      const ContactSurface* list[] = {&f.surface};
      SensorReading reading;
      read_sensor(*f.model, list, reading, RayPath::tet_table, {&f.motion, 1});
      int felt = 0;
      for (std::size_t k = 0; k < 12; ++k) {
        const dvec3 t = expected_friction(f, reading.hits, how, k);
        const TangentFrame frame = tangent_frame(f.model->layout.frame, f.model->layout.taxels[k].normal);
        const double size = 1e-12 * (glm::length(t) + 1e-9);
        EXPECT_NEAR(reading.shear[k].x, glm::dot(t, frame.e1), size) << static_cast<int>(how) << " " << k;
        EXPECT_NEAR(reading.shear[k].y, glm::dot(t, frame.e2), size) << static_cast<int>(how) << " " << k;
        felt += glm::length(t) > 0 ? 1 : 0;
      }
      EXPECT_GE(felt, 2);
    }
  }
}

// The sum of the friction over the taxels is the tangential force of the traction.
TEST(Shear, AddsUpToTheTractionForFullCover) {
  Layout layout = plate(Aggregate::force)->layout;
  for (Taxel& taxel : layout.taxels) taxel.radius = 0.025;
  const SensorModelPtr model =
      build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
  const ContactSurface surface = patch(2e4, dvec3(1e5, 2e5, 0));
  const ContactSurface* list[] = {&surface};
  const SurfaceMotion motions[] = {{{0, 0.4}, {dvec3(1e-4, -2e-4, 0), dvec3(0)}}};
  SensorReading reading;
  read_sensor(*model, list, reading, RayPath::tet_table, motions);
  dvec3 sum(0);
  for (const dvec3& f : reading.force.friction) sum += f;
  const Traction whole = traction(surface, motions[0].properties, motions[0].V);
  EXPECT_LT(glm::distance(sum, whole.wrench.force - whole.elastic.force), 1e-12 * glm::length(sum));
  EXPECT_GT(glm::length(sum), 0.1);
}

TEST(Shear, LeavesTheReadingsUnchanged) {
  for (const Aggregate how : kAll) {
    const Finger with(how), without(how, Misses::zero, false);
    const ContactSurface* list[] = {&with.surface};
    SensorReading rubbed, plain;
    read_sensor(*with.model, list, rubbed, RayPath::tet_table, {&with.motion, 1});
    read_sensor(*without.model, list, plain);
    EXPECT_EQ(rubbed.values, plain.values);
    EXPECT_TRUE(plain.shear.empty());
    read_sensor(*with.model, list, rubbed);
    EXPECT_EQ(rubbed.shear, std::vector<dvec2>(12, dvec2(0))) << "without motions nothing slides";
  }
}

TEST(Shear, AllocatesNothingAfterTheFirstStep) {
  for (const Aggregate how : kAll) {
    const Finger f(how);
    const ContactSurface* list[] = {&f.surface};
    SensorReading reading;
    read_sensor(*f.model, list, reading, RayPath::tet_table, {&f.motion, 1});
    const long before = allocation_count();
    for (int i = 0; i < 3; ++i) read_sensor(*f.model, list, reading, RayPath::tet_table, {&f.motion, 1});
    EXPECT_EQ(allocation_count() - before, 0) << static_cast<int>(how);
  }
}

}  // namespace
}  // namespace taxel
