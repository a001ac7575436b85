// Forces on taxels by integration over contact polygons: closed forms, an oracle of many points, and properties of any
// contact.
#include "core/sensor/reference/force_integral.h"
#include "core/base/math.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/hydro/intersect.h"
#include "core/hydro/quadrature.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/counted_new.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Taxels on a plate of 20 x 20 x 4 mm that read forces.
struct Plate {
  Layout layout;
  Plate() {
    layout.mesh.file = "plate";
    layout.sampling.density = 1e5;
    layout.readout.aggregate = Aggregate::force;
  }
  void add(int id, const dvec3& center, double radius, const dvec3& normal = dvec3(0, 0, 1)) {
    layout.taxels.push_back({id, "", center, normal, radius, {}});
  }
  [[nodiscard]] SensorModelPtr model() const {
    return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
  }
};

ForceReading force_of(const SensorModel& model, const ContactSurface& surface) {
  SensorReading reading;
  const ContactSurface* list[] = {&surface};
  read_sensor(model, list, reading);
  EXPECT_EQ(reading.values, reading.force.values);
  return reading.force;
}

/// A patch for x from lo to hi, 1 mm below the upper face of the plate and farther than that from its sides in y,
/// divided into `parts` x `parts` polygons.
constexpr double kPatchWidth = 0.0178;
ContactSurface patch(double lo, double hi, double base, const dvec3& slope, int parts = 1) {
  ContactSurface surface;
  const double z = 0.001, y = kPatchWidth / 2;
  const auto at = [&](int i, int j) { return dvec3(lo + (hi - lo) * i / parts, -y + 2 * y * j / parts, z); };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      add_polygon(surface, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, base, slope);
  return surface;
}

// Every point is in a field, so the sum over the taxels is the whole force for any subdivision of the quadrature.
TEST(ForceIntegral, GivesTheWholeForceForFullCover) {
  Plate plate;
  plate.add(0, dvec3(-0.004, 0, 0.002), 0.018);
  plate.add(1, dvec3(0.005, 0.003, 0.002), 0.019);
  const SensorModelPtr model = plate.model();
  const dvec3 slope(8e5, -3e5, 0);
  const double whole = 0.008 * kPatchWidth * (2e4 + slope.x * 0.001);
  for (const int parts : {1, 7}) {
    const ForceReading force = force_of(*model, patch(-0.003, 0.005, 2e4, slope, parts));
    EXPECT_NEAR(sum_of(force.values), whole, 1e-13 * whole);
    EXPECT_NEAR(force.covered, whole, 1e-13 * whole);
    EXPECT_NEAR(force.uncovered, 0.0, 1e-13 * whole);
    EXPECT_GT(force.values[0], 0.2 * whole);
    EXPECT_GT(force.values[1], 0.2 * whole);
  }
}

// A single taxel reads the force within its radius: the pressure at its centre times the disc. A half-plane through the
// centre covers half of the disc, with the first moment 2 r^3 / 3 of the half disc.
TEST(ForceIntegral, GivesOneTaxelTheForceOnItsDisc) {
  Plate plate;
  const dvec3 c(0.001, 0.002, 0.002);
  const double r = 0.006;
  plate.add(7, c, r);
  const SensorModelPtr model = plate.model();
  const dvec3 slope(8e5, -4e5, 0);
  const double p = 2e4 + slope.x * c.x + slope.y * c.y, disc = kPi * r * r;
  for (const int parts : {1, 3, 40}) {
    const ForceReading whole = force_of(*model, patch(-0.01, 0.01, 2e4, slope, parts));
    EXPECT_NEAR(whole.values[0], p * disc, 1e-3 * p * disc) << parts;
    EXPECT_NEAR(whole.values[0] + whole.uncovered, 0.02 * kPatchWidth * 2e4, 1e-12);
    const double half_force = p * disc / 2 + slope.x * 2 * r * r * r / 3;
    const ForceReading half = force_of(*model, patch(c.x, 0.01, 2e4, slope, parts));
    EXPECT_NEAR(half.values[0], half_force, 1e-3 * half_force) << parts;
  }
}

// Two equal fields at the distance a share the union of their discs, 2 pi r^2 minus the lens that is in both.
TEST(ForceIntegral, SharesTheUnionBetweenTwoEqualTaxels) {
  Plate plate;
  const double r = 0.004, a = 0.005, p = 1e4;
  plate.add(0, dvec3(-a / 2, 0.001, 0.002), r);
  plate.add(1, dvec3(a / 2, 0.001, 0.002), r);
  const ForceReading force = force_of(*plate.model(), patch(-0.01, 0.01, p, dvec3(0), 9));
  const double lens = 2 * r * r * std::acos(a / (2 * r)) - a / 2 * std::sqrt(4 * r * r - a * a);
  const double each = p * (kPi * r * r - lens / 2);
  EXPECT_NEAR(force.values[0], each, 1e-3 * each);
  EXPECT_NEAR(force.values[1], each, 1e-3 * each);
}

// Compares the shares in the overlap of three fields with a sum over a fine grid of points.
TEST(ForceIntegral, SharesForcesByTheWeights) {
  Plate plate;
  plate.add(0, dvec3(-0.002, 0, 0.002), 0.006);
  plate.add(1, dvec3(0.002, 0.001, 0.002), 0.003);
  plate.add(2, dvec3(0.001, -0.003, 0.002), 0.005);
  const dvec3 slope(5e5, 2e5, 0);
  const ForceReading force = force_of(*plate.model(), patch(-0.01, 0.01, 2e4, slope, 20));
  std::vector<double> expected(3, 0.0);
  const int n = 1500;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const dvec3 x(-0.01 + 0.02 * (i + 0.5) / n, kPatchWidth * ((j + 0.5) / n - 0.5), 0.002);
      double w[3], sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Taxel& t = plate.layout.taxels[k];
        const double left = std::max(0.0, t.radius - glm::distance(t.center, x));
        sum += w[k] = left * left;
      }
      for (std::size_t k = 0; k < 3 && sum > 0; ++k)
        expected[k] += w[k] / sum * (2e4 + glm::dot(slope, x)) * 0.02 * kPatchWidth / n / n;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(force.values[k], expected[k], 1e-3 * expected[k]) << k;
}

TEST(ForceIntegral, CoversByDiscsAngleLimitAndDepth) {
  const double p = 1e4, r = 0.002, disc = p * kPi * r * r;
  const ContactSurface surface = patch(-0.01, 0.01, p, dvec3(0), 11);
  Plate plate;
  plate.add(0, dvec3(0, 0, 0.002), 0.006);
  plate.layout.taxels[0].subtaxels = {{dvec3(-0.004, 0, 0.002), dvec3(0, 0, 1), r},
                                      {dvec3(0.004, 0, 0.002), dvec3(0, 0, 1), r},
                                      {dvec3(0.004, 0, 0.002), dvec3(1, 0, 0), 0.006}};
  EXPECT_NEAR(force_of(*plate.model(), surface).values[0], 2 * disc, 2e-3 * disc);
  plate.layout.readout.max_depth = 0.0009;  // the patch is deeper
  const ForceReading none = force_of(*plate.model(), surface);
  EXPECT_EQ(none.values[0], 0.0);
  EXPECT_NEAR(none.uncovered, 0.02 * kPatchWidth * p, 1e-12);
}

/// Returns a block of 20 x 18 x 18 mm without its quarter y > 0, z < 0, with its faces in either order.
TriMeshPtr notched_block(bool reversed) {
  const std::array<dvec2, 6> profile{
      {{-0.010, -0.008}, {0, -0.008}, {0, 0}, {0.008, 0}, {0.008, 0.010}, {-0.010, 0.010}}};
  std::vector<dvec3> vertices;
  for (const double x : {-0.010, 0.010})
    for (const dvec2& q : profile) vertices.emplace_back(x, q.x, q.y);
  std::vector<ivec3> faces;
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    faces.insert(faces.end(), {{i, j, j + 6}, {i, j + 6, i + 6}});
    if (i != 2 && j != 2) faces.insert(faces.end(), {{8, i + 6, j + 6}, {2, j, i}});
  }
  if (reversed) std::reverse(faces.begin(), faces.end());
  return std::make_shared<TriMesh>(std::move(vertices), std::move(faces));
}

// The nearest skin of the whole contact is the inner edge of a notch. Below the edge the skin faces +y, next to it -z.
// The direction to the edge is less than 45 degrees from +y for z < -y, and less than 45 degrees from -z otherwise.
TEST(ForceIntegral, UsesTheDirectionIfAnEdgeIsNearest) {
  const double depth = 0.002, width = 0.006, p = 1e4, half = p * width * depth;
  ContactSurface surface;
  add_polygon(surface,
              {{-width / 2, -depth, 0},
               {width / 2, -depth, 0},
               {width / 2, -depth, 2 * depth},
               {-width / 2, -depth, 2 * depth}},
              p, dvec3(0));
  Plate plate;
  plate.add(0, dvec3(0), 0.008, dvec3(0, 1, 0));
  plate.add(1, dvec3(0), 0.008, dvec3(0, 0, -1));
  plate.layout.readout.max_depth = 0.006;
  for (const bool reversed : {false, true}) {
    const SensorModelPtr model = build_sensor_model(plate.layout, notched_block(reversed), "", "block");
    const ForceReading force = force_of(*model, surface);
    EXPECT_NEAR(force.values[0], half, 1e-3 * half) << reversed;
    EXPECT_NEAR(force.values[1], half, 1e-3 * half) << reversed;
    EXPECT_NEAR(force.uncovered, 0.0, 1e-3 * half) << reversed;
  }
}

/// The finger of the project with any metric, pressed onto a box at several places.
struct Finger {
  SensorModelPtr model;
  std::vector<ContactSurface> surfaces;
  explicit Finger(Metric metric = Metric::euclidean, bool reversed = false) {
    static const SensorModelPtr base = load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
    Layout layout = base->layout;
    layout.receptive_field.metric = metric;
    layout.readout.aggregate = Aggregate::force;
    layout.sampling.density = 1e5;
    if (reversed) std::reverse(layout.taxels.begin(), layout.taxels.end());
    model = build_sensor_model(layout, base->mesh, "", "finger");
    for (int i = 0; i < 4; ++i) press(0.002 * i, 0.3 * i);
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
};

/// Computes the integrals by their definition, over 4^level parts of every triangle.
ForceReading oracle(const SensorModel& model, const ContactSurface& surface, int level) {
  ForceReading sum;
  sum.values.assign(model.layout.taxels.size(), 0.0);
  const double min_cos = std::cos(model.layout.receptive_field.max_angle_deg * kPi / 180);
  const int n = 1 << level;
  for (const ContactPolygon& polygon : surface.polygons) {
    for_each_triangle(surface, polygon, [&](const dvec3& a, const dvec3& b, const dvec3& c, double area) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // centroids of the parts of row i
          const double u = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n, v = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n;
          const dvec3 x = u * a + v * b + (1 - u - v) * c;
          const double force = area / n / n * (polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid));
          const SurfacePoint s = model.skin->closest_point(x);
          const bool in_face = s.barycentric.x > 0 && s.barycentric.y > 0 && s.barycentric.z > 0;
          const dvec3 normal = in_face ? model.skin->mesh().face_normals()[at(s.face)] : glm::normalize(s.position - x);
          std::vector<double> w;
          for (const Taxel& t : model.layout.taxels) {
            const double left = std::max(0.0, t.radius - glm::distance(t.center, s.position));
            w.push_back(glm::dot(normal, glm::normalize(t.normal)) > min_cos ? left * left : 0.0);
          }
          const double all = sum_of(w);
          for (std::size_t k = 0; k < w.size() && all > 0; ++k) sum.values[k] += w[k] / all * force;
          (all > 0 ? sum.covered : sum.uncovered) += force;
        }
      }
    });
  }
  return sum;
}

TEST(ForceIntegral, EqualsItsDefinitionOnAFinger) {
  const Finger f;
  for (const ContactSurface& surface : f.surfaces) {
    const ForceReading force = force_of(*f.model, surface), expected = oracle(*f.model, surface, 3);
    ASSERT_GT(expected.covered, 0.1);
    EXPECT_NEAR(force.covered, expected.covered, 1e-3 * expected.covered);
    EXPECT_NEAR(force.uncovered, expected.uncovered, 1e-3 * expected.covered);
    for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(force.values[k], expected.values[k], 1e-3 * expected.covered) << k;
  }
}

void expect_whole(const ForceReading& force, const ContactSurface& surface) {
  const dvec3 elastic = pressure_wrench(surface).force;
  dvec3 sum = force.uncovered_normal;
  for (const dvec3& n : force.normal) sum += n;
  EXPECT_LT(glm::distance(sum, elastic), 1e-12 * glm::length(elastic));
  EXPECT_NEAR(sum_of(force.values), force.covered, 1e-13 * force.covered);
  EXPECT_GT(glm::length(elastic), 0.1);
}

TEST(ForceIntegral, AddsTaxelsAndRestUpToTheElasticForce) {
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    const Finger f(metric);
    bool rest = false;
    for (const ContactSurface& surface : f.surfaces) {
      const ForceReading force = force_of(*f.model, surface);
      expect_whole(force, surface);
      rest = rest || force.uncovered > 0.01 * force.covered;
    }
    EXPECT_TRUE(rest) << "a part that no taxel reaches was among them";
  }
}

TEST(ForceIntegral, ReadsTheContactInTheSkinOfARigidSensor) {
  const Finger soft;
  Layout layout = soft.model->layout;
  layout.material.modulus = 0;
  const SensorModelPtr model = build_sensor_model(layout, soft.model->mesh, "", "finger");
  const HydroBodyPtr ball = make_body({ShapeType::sphere, dvec3(0.02)}, Material{.modulus = 5e4}, "ball");
  ContactSurface surface;
  IntersectWorkspace workspace;
  const Aabb& bounds = model->mesh->bounds();
  Pose X_WB;
  X_WB.p = bounds.center() - dvec3(0, 0.5 * bounds.extent().y + 0.018, 0);
  intersect(*model->body, *ball, Pose{}, X_WB, surface, workspace);
  const ForceReading force = force_of(*model, surface), expected = oracle(*model, surface, 3);
  expect_whole(force, surface);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(force.values[k], expected.values[k], 1e-3 * expected.covered) << k;
}

// Geodesic distances are longer on a curved skin, and equal on a flat one.
TEST(ForceIntegral, IsEqualForGeodesicFieldsOnlyOnAFlatFace) {
  Plate plate;
  plate.add(0, dvec3(-0.002, 0, 0.002), 0.004);
  plate.add(1, dvec3(0.003, 0.001, 0.002), 0.005);
  const ContactSurface surface = patch(-0.008, 0.008, 2e4, dvec3(5e5, 0, 0), 12);
  const ForceReading straight = force_of(*plate.model(), surface);
  plate.layout.receptive_field.metric = Metric::geodesic;
  const ForceReading along = force_of(*plate.model(), surface);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(along.values[k], straight.values[k], 1e-3 * straight.values[k]);
  const Finger euclidean, geodesic(Metric::geodesic);
  double less = 0;
  for (std::size_t i = 0; i < euclidean.surfaces.size(); ++i) {
    const double a = force_of(*euclidean.model, euclidean.surfaces[i]).covered;
    const double b = force_of(*geodesic.model, geodesic.surfaces[i]).covered;
    EXPECT_LT(b, a * 1.0005);
    less = std::max(less, 1 - b / a);
  }
  EXPECT_GT(less, 5e-4);
}

TEST(ForceIntegral, KeepsEveryBitForAnyOrderOfTaxels) {
  const Finger f, reversed(Metric::euclidean, true);
  for (std::size_t i = 0; i < f.surfaces.size(); ++i) {
    const std::vector<double> values = force_of(*f.model, f.surfaces[i]).values;
    std::vector<double> others = force_of(*reversed.model, f.surfaces[i]).values;
    std::reverse(others.begin(), others.end());
    EXPECT_EQ(values, others);
  }
}

// contact.md, target 4: in a slide by 10 micrometres, no taxel jumps by more than 1 % of its peak.
TEST(ForceIntegral, SlidesWithoutJumps) {
  Finger f;
  f.surfaces.clear();
  for (int i = 0; i < 120; ++i) f.press(0.019 + 1e-5 * i, 0.2);
  std::vector<double> peak(12, 0.0), jump(12, 0.0), last;
  for (const ContactSurface& surface : f.surfaces) {
    const std::vector<double> values = force_of(*f.model, surface).values;
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
    RecordProperty("jump_" + std::to_string(k), std::to_string(jump[k] / peak[k]));
  }
}

TEST(ForceIntegral, AllocatesNothingAfterTheFirstStep) {
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    const Finger f(metric);
    SensorReading reading;
    std::vector<const ContactSurface*> all;
    for (const ContactSurface& surface : f.surfaces) all.push_back(&surface);
    read_sensor(*f.model, all, reading);
    const long before = allocation_count();
    for (int i = 0; i < 3; ++i) {
      for (const ContactSurface* surface : all) read_sensor(*f.model, {&surface, 1}, reading);
      read_sensor(*f.model, all, reading);
    }
    EXPECT_EQ(allocation_count() - before, 0);
  }
}

TEST(ForceIntegral, ReadsZeroWithoutContact) {
  Plate plate;
  plate.add(0, dvec3(0, 0, 0.002), 0.004);
  const ForceReading force = force_of(*plate.model(), {});
  EXPECT_EQ(force.values, std::vector<double>{0.0});
  EXPECT_EQ(force.uncovered, 0.0);
}

}  // namespace
}  // namespace taxel
