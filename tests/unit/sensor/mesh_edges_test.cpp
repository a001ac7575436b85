// Mesh edges as the cause of a jump: closed forms on a roof and in a groove, the edges that a contact crossed, remedies
// with the predicted effect, and no such cause on a smooth mesh.
#include <gtest/gtest.h>

#include <cmath>

#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/explain/explanation.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/labelled_touches.h"
#include "fixtures/roof_mesh.h"
#include "unit/sensor/labelled_case.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

constexpr double kFaceWidth = 0.004, kPressed = 2e4, kOneDegree = kPi / 180;
/// Depth of the pressed rectangles on a roof [m]. It is so small that the directions of the rays do not matter.
constexpr double kSkinDepth = 1e-6;
constexpr double kHalfSquare = 0.0002;  // half of the side of a pressed square [m]

/// A taxel whose reading is the mean pressure, on a roof or in a groove.
struct Slopes {
  double bend_deg = 0;
  SensorModelPtr model;

  Slopes(double bend, double max_angle, const dvec3& center, const dvec3& normal, double radius) : bend_deg(bend) {
    Layout layout = test::layout_of(FieldKind::pad, 4e6);
    layout.readout.aggregate = Aggregate::mean;
    layout.readout.method = ReadingMethod::exact;
    layout.receptive_field.max_angle_deg = max_angle;
    layout.taxels = {{7, "", center, normal, radius, {}}};
    model = test::preview_model(layout, test::roof_mesh(bend, kFaceWidth));
  }
  /// Returns a step in which a square of uniform pressure is pressed, with its middle and an edge along the surface.
  [[nodiscard]] SensorStep pressed(const dvec3& middle, const dvec3& along) const {
    SensorStep step;
    step.model = model;
    const dvec3 u = kHalfSquare * along, v = kHalfSquare * dvec3(0, 1, 0);
    add_polygon(step.surfaces.emplace_back(), {middle - u - v, middle + u - v, middle + u + v, middle - u + v},
                kPressed, dvec3(0));
    SensorReading reading;
    read_sensor(*model, surface_pointers(step), reading);
    step.readings = reading.values;
    step.hits = reading.hits.all();
    step.force_W = dvec3(0, 0, 1);
    return step;
  }
};

/// Returns the direction down the slope on the right (+1) or on the left (-1), and the normal of the slope.
dvec3 down(double bend_deg, double side) {
  const double a = 0.5 * bend_deg * kOneDegree;
  return {side * std::cos(a), 0, -std::sin(a)};
}
dvec3 normal(double bend_deg, double side) {
  const double a = 0.5 * bend_deg * kOneDegree;
  return {side * std::sin(a), 0, std::cos(a)};
}

/// A square that moves over the edge of a roof whose slopes are 60 degrees apart, from one slope to 0.5 mm behind the
/// edge. The taxel is 1 mm before the edge, and its limit of 45 degrees excludes the other slope.
struct OverRoof : Slopes {
  static constexpr double kAway = 0.001, kReach = 0.003;
  SensorStep before, now;
  ExplainLimits limits{.jump = 0.1, .equal_force = 0.02, .largest = 0};
  OverRoof() : Slopes(60, 45, kAway * down(60, -1), normal(60, -1), kReach) {
    before = on(-1), now = on(1);
    limits.largest = before.readings[0];
  }
  [[nodiscard]] SensorStep on(double side) const {
    return pressed(0.0005 * down(60, side) - kSkinDepth * normal(60, side), down(60, side));
  }
};

// The mean is p A / S: A the square, S the part of the field on the taxel's slope, a disc without the segment behind
// the edge. Behind the edge it is 0: the whole reading is lost. With interpolated normals the field reaches the angle
// of 45 degrees within the next face, behind the square, so nothing changes.
TEST(MeshEdges, MakeTheWholeReadingOnARoof) {
  const OverRoof roof;
  const double r = OverRoof::kReach, c = OverRoof::kAway;
  const double field = kPi * r * r - (r * r * std::acos(c / r) - c * std::sqrt(r * r - c * c));
  const double mean = kPressed * 4 * kHalfSquare * kHalfSquare / field;
  EXPECT_NEAR(roof.before.readings[0], mean, 2e-3 * mean);
  EXPECT_EQ(roof.now.readings[0], 0);
  const Explanation e = Explainer().explain(0, roof.now, &roof.before, roof.limits);
  const Verdict& v = e.change->verdict;
  EXPECT_EQ(v.cause, Cause::mesh_edges) << v.text;
  EXPECT_NEAR(v.edges, -mean, 0.01 * mean);
  EXPECT_NEAR(v.cone, 0, 0.01 * mean);
  EXPECT_NEAR(v.contact, 0, 0.01 * mean);
  EXPECT_EQ(v.noise + v.field + v.cone + v.edges + v.contact, v.change);
  EXPECT_EQ(v.text.rfind("Mesh edges: the reading fell by 100 % of the taxel's largest", 0), 0U) << v.text;
}

// The normal turns from the bisector, 30 degrees from the taxel's, by the angle phi with tan phi = t sin 30 / (1 - t +
// t cos 30) at the fraction t of the first face. It is at the limit where phi = 15 degrees.
TEST(MeshEdges, EndTheInterpolatedFieldWhereTheNormalReachesTheLimit) {
  const OverRoof roof;
  const double tan = std::tan(15 * kOneDegree), sine = std::sin(30 * kOneDegree), cosine = std::cos(30 * kOneDegree);
  const double end = kFaceWidth * tan / (sine + tan * (1 - cosine));
  ASSERT_GT(end, 0.0005 + kHalfSquare);
  const SensorModel smooth = with_interpolated_angles(*roof.model);
  const auto reads = [&](double place) {
    const SensorStep step = roof.pressed(place * down(60, 1) - kSkinDepth * normal(60, 1), down(60, 1));
    return *exact_reading(smooth, 0, surface_pointers(step), {.rays = FieldNormals::interpolated}).value > 0;
  };
  EXPECT_TRUE(reads(end - 0.9 * kHalfSquare));
  EXPECT_FALSE(reads(end + 1.1 * kHalfSquare));
}

TEST(MeshEdges, AreNamedWithBendDistanceAndFaces) {
  const OverRoof roof;
  const std::vector<CrossedEdge> crossed = crossed_edges(0, roof.before, roof.now);
  ASSERT_FALSE(crossed.empty());
  const CrossedEdge& edge = crossed.front();
  EXPECT_NEAR(edge.bend_deg, 60, 1e-9);
  EXPECT_NEAR(edge.distance, OverRoof::kAway, 1e-12);
  EXPECT_NEAR(edge.force, kPressed * 4 * kHalfSquare * kHalfSquare, 1e-12);
  const TriMesh& mesh = *roof.model->mesh;
  const double first = mesh.face_normals()[static_cast<std::size_t>(edge.faces[0])].x;
  EXPECT_NEAR(std::abs(first), 0.5, 1e-12) << "a face of a slope";
  EXPECT_NEAR(mesh.face_normals()[static_cast<std::size_t>(edge.faces[1])].x, -first, 1e-12) << "and of the other";
  for (const CrossedEdge& e : crossed) EXPECT_GT(e.bend_deg, kFlatEdge) << "edges inside of a slope are flat";
  EXPECT_TRUE(crossed_edges(0, roof.before, roof.before).empty()) << "at rest";
  const SensorStep near = roof.pressed(0.0009 * down(60, -1) - kSkinDepth * normal(60, -1), down(60, -1));
  EXPECT_TRUE(crossed_edges(0, roof.before, near).empty()) << "on one slope";
}

// Rays from the two slopes of a groove diverge: at the depth d none reaches |x| < d tan a, a half of the bend. There a
// square reads 0; at the side it reads p A cos a / (pi r^2). Interpolated, the normal turns within the first face, and
// the ray from s reaches x = s cos a + tan f(s) (d + s sin a), tan f = tan of the interpolated angle, so that the
// reading is p 2 h (s(x + h) - s(x - h)) / (pi r^2).
TEST(MeshEdges, LeaveAGapBelowAGroove) {
  constexpr double kBend = -40, kDeep = 0.001, kReach = 0.004, kSide = 0.0012;
  const double a = 20 * kOneDegree;
  Slopes groove(kBend, 180, dvec3(0), dvec3(0, 0, 1), kReach);
  ASSERT_LT(kHalfSquare, kDeep * std::tan(a));
  const SensorStep before = groove.pressed(dvec3(kSide, 0, -kDeep), dvec3(1, 0, 0));
  const SensorStep now = groove.pressed(dvec3(0, 0, -kDeep), dvec3(1, 0, 0));
  const double area = kPi * kReach * kReach, whole = kPressed * 4 * kHalfSquare * kHalfSquare / area;
  const double side = whole * std::cos(a);
  EXPECT_NEAR(before.readings[0], side, 0.01 * side);
  EXPECT_EQ(now.readings[0], 0);
  const auto start = [&](double x) {  // s(x) by bisection, for x > 0
    double low = 0, high = kFaceWidth;
    for (int i = 0; i < 60; ++i) {
      const double s = 0.5 * (low + high), t = s / kFaceWidth;
      const double tan = t * std::sin(a) / (1 - t + t * std::cos(a));
      (s * std::cos(a) + tan * (kDeep + s * std::sin(a)) < x ? low : high) = s;
    }
    return low;
  };
  const double smooth_side = whole * (start(kSide + kHalfSquare) - start(kSide - kHalfSquare)) / (2 * kHalfSquare);
  const double smooth_middle = whole * start(kHalfSquare) / kHalfSquare;
  const double scale = side / (smooth_side + smooth_middle);
  const ExplainLimits limits{.jump = 0.1, .equal_force = 0.02, .largest = side};
  const Verdict v = Explainer().explain(0, now, &before, limits).change->verdict;
  EXPECT_NEAR(v.edges, -side - scale * (smooth_middle - smooth_side), 0.02 * side);
  EXPECT_EQ(v.cause, Cause::mesh_edges) << v.text;
}

// Each setting has the change that a sensor built with the setting has, and the sentence names one that helps.
TEST(MeshEdges, HaveRemediesWithThePredictedEffect) {
  const OverRoof roof;
  const Verdict v = Explainer().explain(0, roof.now, &roof.before, roof.limits).change->verdict;
  ASSERT_FALSE(v.tried.empty());
  const double sum = roof.before.readings[0] + roof.now.readings[0];
  for (const SettingTried& setting : v.tried) {
    Layout layout = roof.model->layout;
    layout.receptive_field = setting.field;
    layout.readout = setting.readout;
    layout.taxels[0].radius *= setting.radius;
    const SensorModelPtr other = test::preview_model(layout, roof.model->mesh);
    const auto read = [&](const SensorStep& step) {
      SensorReading reading;
      read_sensor(*other, surface_pointers(step), reading);
      return reading.values[0];
    };
    const double was = read(roof.before), is = read(roof.now);
    EXPECT_NEAR(setting.change, sum / (was + is) * (is - was), 1e-9 * sum) << setting.text;
    EXPECT_EQ(setting.cures, std::abs(setting.change) <= 0.9 * v.limit) << setting.text;
  }
  EXPECT_TRUE(v.tried.back().cures);
  EXPECT_NE(v.text.find("With angles from normals interpolated over the faces it would be "), std::string::npos)
      << v.text;
  EXPECT_NE(v.text.find(" instead of 100 %, below the limit."), std::string::npos) << v.text;
}

TEST(MeshEdges, GiveNoAdviceThatDoesNotHelp) {
  std::vector<SettingTried> tried(2);
  tried[0].change = 95, tried[1].change = -98;
  EXPECT_EQ(best_setting(tried, 90), nullptr);
  tried[1].change = -60;
  EXPECT_EQ(best_setting(tried, 90), &tried[1]);
  tried[0].change = 70, tried[0].cures = true;
  EXPECT_EQ(best_setting(tried, 90), &tried[0]) << "the first that cures";
}

// On a fine cylinder the normals of the faces hardly change at an edge: what changes is the contact.
TEST(MeshEdges, AreNoCauseOnASmoothMesh) {
  test::Touch touch = test::led_along(0.003, 0.0005);
  touch.layout.sampling.density = 1.5e6;
  touch.path.resize(14);
  touch.mesh = test::finger_mesh(0.0008);
  const Verdict v = test::sensed(touch).explain_largest_jump().change->verdict;
  EXPECT_FALSE(v.crossed.empty());
  EXPECT_LT(std::abs(v.edges), 0.05 * std::abs(v.change)) << v.text;
  EXPECT_EQ(v.cause, Cause::redistribution) << v.text;
}

}  // namespace
}  // namespace taxel
