// The parts of an explanation agree with each other and with independent results.
#include "core/sensor/explain/explainer.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

struct TwoSteps {
  test::LabelledCase c;
  SensorStep before, now;
  ExplainLimits limits{0.1, 0.02, 2e3};
  explicit TwoSteps(Aggregate how, SampleWeights weights = SampleWeights::equal) {
    const TriMeshPtr mesh = test::finger_mesh();
    Layout layout = test::layout_of(FieldKind::pad, 2e6, weights);
    layout.readout.aggregate = how;
    test::add_row(layout, mesh);
    c.model = test::preview_model(layout, mesh);
    c.other = test::rigid_ball(0.003);
    const auto path = test::along_finger(0.003, 0.001, 0.0, 0.0008, 2);
    before = c.sense(path[0], 1.0), now = c.sense(path[1], 1.1);
  }
  [[nodiscard]] Explanation explain(int taxel) const { return Explainer().explain(taxel, now, &before, limits); }
};

TEST(Explanation, TriesTheRemedyOnTheLargestStepOfTheRunToo) {
  TwoSteps two(Aggregate::weighted_mean);
  two.limits.jump = 1e-3;
  Pose beside;
  beside.p = dvec3(1);
  const SensorStep away = two.c.sense(beside, 1.2);
  const Explanation e = Explainer().explain(2, two.now, &two.before, two.limits, nullptr, {&two.now, &away});
  const Verdict& v = e.change->verdict;
  ASSERT_GT(two.now.readings[2], std::max(std::abs(v.change), v.limit)) << "the lift is the larger step";
  ASSERT_TRUE(v.worst);
  EXPECT_EQ(v.worst->time, 1.2);
  EXPECT_EQ(v.worst->change, -two.now.readings[2]);
  EXPECT_EQ(v.worst->needed.has_value(), v.cause == Cause::sampling_noise || v.cause == Cause::none);
  const Explanation same = Explainer().explain(2, away, &two.now, two.limits, nullptr, {&two.now, &away});
  EXPECT_FALSE(same.change->verdict.worst) << "it is the explained one";
}

TEST(Explanation, HasPartsThatAddUpForEveryAggregate) {
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::weighted_sum, Aggregate::mean, Aggregate::nearest,
                              Aggregate::max, Aggregate::force}) {
    const TwoSteps two(how);
    const Explanation e = two.explain(2);
    const StepChange& change = *e.change;
    EXPECT_EQ(e.reading, two.now.readings[2]);
    EXPECT_EQ(change.reading.before, two.before.readings[2]);
    const double unit = std::max(e.reading, change.reading.before);
    EXPECT_GT(unit, 0.0);
    EXPECT_NEAR(change.began.change + change.ceased.change + change.stayed.change, change.reading.change(),
                1e-9 * unit);
    const Verdict& v = change.verdict;
    EXPECT_NEAR(v.noise + v.field + v.cone + v.edges + v.contact, v.change, 1e-9 * unit);
    double share = 0, force = 0, exact = 0;
    int samples = 0;
    for (const PolygonBehind& p : e.polygons) {
      share += p.share, force += p.force_share, exact += p.exact_share, samples += p.samples;
      EXPECT_LE(p.lowest, p.mean * (1 + 1e-9));
      EXPECT_GE(p.highest, p.mean * (1 - 1e-9));
      const bool served = std::find(p.taxels.begin(), p.taxels.end(), e.id) != p.taxels.end();
      EXPECT_EQ(served, p.samples > 0);
    }
    EXPECT_NEAR(share, 1.0, 1e-9);
    EXPECT_NEAR(force, 1.0, 1e-9);
    EXPECT_EQ(samples, static_cast<int>(std::count_if(e.samples.begin(), e.samples.end(),
                                                      [](const TaxelSampleReading& s) { return s.hit; })));
    EXPECT_NEAR(exact, e.exact.parts.empty() ? 0.0 : 1.0, 1e-9);
    EXPECT_EQ(e.levels->now[1], e.reading);
    EXPECT_EQ(e.levels->before[1], change.reading.before);
  }
}

// A force needs no samples: the exact reading equals the reading for any number of samples.
TEST(Explanation, HasNoNoiseForAForce) {
  const Explanation e = TwoSteps(Aggregate::force).explain(2);
  EXPECT_EQ(*e.exact.value, e.reading);
  EXPECT_EQ(e.change->verdict.noise, 0.0);
  ASSERT_FALSE(e.levels->now.empty());
  for (const double v : e.levels->now) EXPECT_EQ(v, e.reading);
}

TEST(Explanation, HasTheForceOfTheContactAsBudget) {
  const TwoSteps two(Aggregate::weighted_mean);
  Explanation e = two.explain(2);
  const ForceBudget& b = e.budget;
  EXPECT_NEAR(b.covered + b.uncovered, b.pressed, 1e-9 * b.pressed);
  EXPECT_NEAR(glm::length(b.surfaces_W), two.c.force(test::along_finger(0.003, 0.001, 0.0, 0.0008, 2)[1]), 1e-12);
  EXPECT_LE(glm::length(b.taxel_W), glm::length(b.taxels_W));
  EXPECT_EQ(b.net_W, two.now.force_W);
}

TEST(Explanation, ExplainsAStepWithoutAPreviousOne) {
  const TwoSteps two(Aggregate::weighted_mean);
  const Explanation e = Explainer().explain(1, two.now, nullptr, two.limits);
  EXPECT_FALSE(e.change.has_value());
  EXPECT_TRUE(e.samples_before.empty());
  EXPECT_THROW(Explainer().explain(9, two.now, nullptr, two.limits), Error);
}

// Explaining the same step twice, or after other steps, gives the same result.
TEST(Explanation, DoesNotDependOnEarlierRequests) {
  const TwoSteps two(Aggregate::weighted_mean);
  Explainer explainer;
  explainer.explain(0, two.before, nullptr, two.limits);
  const Explanation a = explainer.explain(2, two.now, &two.before, two.limits);
  const Explanation b = two.explain(2);
  EXPECT_EQ(a.change->verdict.text, b.change->verdict.text);
  EXPECT_EQ(*a.exact.value, *b.exact.value);
  EXPECT_EQ(a.levels->now, b.levels->now);
}

// The star of a sphere already has uniform stiffness, so its reading under uniform stiffness is equal, to the order of
// its facets.
TEST(Counterfactual, EqualsTheReadingForAUniformStar) {
  const auto mesh = std::make_shared<const TriMesh>(make_sphere(0.01, 0.0015));
  Layout layout = test::layout_of(FieldKind::star, 2e6);
  test::add_taxel(layout, mesh, dvec3(0.01, 0, 0), 0.004);
  test::LabelledCase c;
  c.model = test::preview_model(layout, mesh);
  c.other = test::rigid_ball(0.004);
  const auto step = c.sense({{1, 0, 0, 0}, dvec3(0.0132, 0.0005, 0)});
  ASSERT_TRUE(field_is_suspect(*c.model));
  EXPECT_FALSE(between_soft_bodies(step.surfaces.front()));
  const OtherSurfaces even = with_even_stiffness(*c.model, surface_pointers(step));
  const double own = *exact_reading(*c.model, 0, surface_pointers(step)).value;
  EXPECT_NEAR(*exact_reading(*c.model, 0, even.pointers).value, own, 0.03 * own);
}

TEST(Counterfactual, FindsTheInsideOfATorus) {
  const auto mesh = std::make_shared<const TriMesh>(test::round_ring(0.014, 0.006));
  Layout layout = test::layout_of(FieldKind::star, 1e5);
  test::add_taxel(layout, mesh, dvec3(0.02, 0, 0), 0.004);
  const SensorModelPtr model = test::preview_model(layout, mesh);
  const InvertedTets inverted(*model);
  for (int i = 0; i < 36; ++i) {
    // Angle of the tube, 0 on the outer side; the tangent plane contains the centre at 115.4.
    const double angle = (10 * i) * kPi / 180;
    ContactPolygon polygon;
    polygon.tet = 0;
    polygon.centroid = dvec3(0.014 + 0.0055 * std::cos(angle), 0, 0.0055 * std::sin(angle));
    EXPECT_EQ(inverted.concern(polygon), std::cos(angle) < -6.0 / 14) << i;
  }
}

TEST(Counterfactual, DetectsSurfacesBetweenTwoSoftBodies) {
  ContactSurface surface;
  EXPECT_FALSE(between_soft_bodies(surface));
  surface.polygons.resize(2);
  surface.polygons[0].normal = surface.polygons[1].normal = dvec3(0, 0, 1);
  EXPECT_FALSE(between_soft_bodies(surface));  // a plane
  surface.polygons[1].normal = glm::normalize(dvec3(0.1, 0, 1));
  EXPECT_TRUE(between_soft_bodies(surface));
  surface.polygons[0].face = 3;
  EXPECT_FALSE(between_soft_bodies(surface));
  surface.polygons[0].tet_b = 1;
  EXPECT_TRUE(between_soft_bodies(surface));
}

}  // namespace
}  // namespace taxel
