// Tractions as arrows and readings spread over the skin, against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "core/mesh/make/primitives.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sweep_model.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/marks/marks.h"

namespace taxel::ui {
namespace {

SensorModelPtr ball_model(double radius_of_fields) {
  auto model = std::make_shared<SensorModel>();
  model->mesh = std::make_shared<const TriMesh>(make_icosphere(0.02, 3));
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  for (const dvec3& n : {dvec3(0, 0, 1), dvec3(0, 0.6, 0.8), dvec3(1, 0, 0)}) {
    Taxel& taxel = model->layout.taxels.emplace_back();
    taxel.id = static_cast<int>(model->layout.taxels.size());
    taxel.center = 0.02 * n;
    taxel.normal = n;
    taxel.radius = radius_of_fields;
  }
  return model;
}

/// Returns a square of side 2 mm in z = 0 with a uniform pressure that pushes up.
ContactSurface even_square(double pressure) {
  ContactSurface surface;
  for (const dvec3& p : {dvec3(-1, -1, 0), dvec3(1, -1, 0), dvec3(1, 1, 0), dvec3(-1, 1, 0)}) {
    surface.vertices.push_back(1e-3 * p + dvec3(0.003, 0, 0));
    surface.pressure.push_back(pressure);
  }
  ContactPolygon& polygon = surface.polygons.emplace_back();
  polygon.count = 4;
  polygon.normal = {0, 0, 1};
  polygon.area = 4e-6;
  polygon.centroid = {0.003, 0, 0};
  polygon.pressure = pressure;
  return surface;
}

// The sum of the arrows, times area over scale, is the force that moves the bodies.
TEST(TractionMarks, SumUpToTheForce) {
  const double pressure = 2.0e4;
  SensorStep state;
  state.surfaces = {even_square(pressure)};
  state.motions = {{{3.0, 0.5}, {dvec3(0.02, -0.01, 0.03), dvec3(0)}}};
  SensorView view;
  view.model = ball_model(0.005);
  view.state = &state;
  const TractionMarks marks = traction_marks(view, {0, 4e4}, look(true));
  ASSERT_EQ(marks.normal.size(), 1U);
  ASSERT_EQ(marks.friction.size(), 1U);
  const Traction expected = traction(state.surfaces[0], state.motions[0].properties, state.motions[0].V);
  const double scale = state.surfaces[0].polygons[0].area / marks.numbers.metres_per_pascal;
  const dvec3 sum =
      scale * dvec3(marks.normal[0].b - marks.normal[0].a) + scale * dvec3(marks.friction[0].b - marks.friction[0].a);
  EXPECT_LT(glm::distance(sum, expected.wrench.force), 1e-5 * glm::length(expected.wrench.force));
  EXPECT_NEAR(marks.numbers.largest_pressure, pressure * (1 - 3.0 * 0.03), 1e-9 * pressure);
  EXPECT_TRUE(marks.numbers.friction_known);
  EXPECT_NEAR(glm::length(marks.normal[0].b - marks.normal[0].a), view.model->mesh->bounds().diagonal() / 7 * 0.91 / 2,
              1e-6);
}

// The bristles of a skin at rest carry friction, and those of a moving skin need not follow its velocity.
TEST(TractionMarks, ShowTheFrictionOfBristlesWhereItSticks) {
  SensorStep state;
  state.surfaces = {even_square(1e4), even_square(1e4)};
  state.motions = {{{3.0, 0.5}, {dvec3(0.02, 0, 0), dvec3(0)}}, {{3.0, 0.5}, {dvec3(0.02, 0, 0), dvec3(0)}}};
  state.sticking.resize(2);
  state.sticking[0].reach = 1e-3;
  state.sticking[0].roots = {{{0.003, 0, 0}, {0, 0, 1}, 4e-6, {0, 700, 0}, false}};
  SensorView view;
  view.model = ball_model(0.005);
  view.state = &state;
  const TractionMarks marks = traction_marks(view, {0, 4e4}, look(true));
  ASSERT_EQ(marks.friction.size(), 2U);
  const auto drawn = [&](std::size_t i) {
    return dvec3(marks.friction[i].b - marks.friction[i].a) / marks.numbers.metres_per_pascal;
  };
  EXPECT_LT(glm::distance(drawn(0), dvec3(0, 700, 0)), 0.1);
  EXPECT_LT(drawn(1).x, -4000) << "friction of the other surface is regularised";
  EXPECT_TRUE(marks.numbers.friction_known);
}

/// Returns the sum of arrows times the areas of their polygons, frame M [N].
dvec3 force_of(const Segments& arrows, const SensorStep& state, const TractionNumbers& numbers) {
  std::map<std::array<float, 3>, double> areas;
  for (const ContactSurface& surface : state.surfaces)
    for (const ContactPolygon& polygon : surface.polygons) {
      const glm::vec3 at(polygon.centroid);
      areas[{at.x, at.y, at.z}] += polygon.area;
    }
  dvec3 sum(0);
  for (const Segment& arrow : arrows)
    sum += areas.at({arrow.a.x, arrow.a.y, arrow.a.z}) * dvec3(arrow.b - arrow.a) / numbers.metres_per_pascal;
  return sum;
}

// Arrows are values at centroids, while the force is integrated at several points of each polygon: the friction
// differs by up to 8 % where few polygons touch. Arrows of the velocities alone are off by 15 to 99 % there.
TEST(TractionMarks, SumUpToTheForceOfAContactThatSticks) {
  const auto simulator =
      Simulator::make_scenario(taxel::test::fingertip_model(1e5, 2e8, 4000), taxel::test::box_sweep());
  int compared = 0;
  while (!simulator->finished() && compared < 20) {
    for (int n = 0; n < 25 && !simulator->finished(); ++n) simulator->step();
    SimFrame frame;
    test::fill_frame(*simulator, frame);
    const SensorStep& state = frame.sensors.at(0);
    if (!(glm::length(state.force_W) > 0.05)) continue;
    ++compared;
    SensorView view;
    view.model = state.model;
    view.state = &state;
    const TractionMarks marks = traction_marks(view, {0, 4e4}, look(true));
    ASSERT_TRUE(marks.numbers.friction_known);
    const dvec3 force = glm::inverse(state.X_WM.q) * state.force_W,
                normal = force_of(marks.normal, state, marks.numbers),
                friction = force_of(marks.friction, state, marks.numbers);
    EXPECT_GT(glm::length(friction), 0.1 * glm::length(normal));
    EXPECT_LT(glm::distance(friction, force - normal), 0.1 * glm::length(friction)) << "at " << frame.time;
  }
  EXPECT_EQ(compared, 20);
}

TEST(TractionMarks, ShowOnlyPressureWithoutMotions) {
  SensorStep state;
  state.surfaces = {even_square(1e4)};
  SensorView view;
  view.model = ball_model(0.005);
  view.state = &state;
  const TractionMarks marks = traction_marks(view, {0, 4e4}, look(true));
  EXPECT_EQ(marks.normal.size(), 1U);
  EXPECT_TRUE(marks.friction.empty());
  EXPECT_FALSE(marks.numbers.friction_known);
}

/// Returns the ends of the displayed rays, from 400 hits and 100 misses in a square, `spacing` pixels apart.
std::pair<std::vector<glm::vec3>, std::size_t> shown_rays(double spacing) {
  auto model = std::make_shared<SensorModel>(*ball_model(0.005));
  SensorStep state;
  for (int i = 0; i < 500; ++i) {
    model->rays.push_back({i, dvec3(i % 25, i / 25, 0), dvec3(0, 0, 1), 1.0});
    state.hits.push_back({.surface = i % 5 == 4 ? -1 : 0, .polygon = 0, .depth = 0.5, .pressure = 1e3});
  }
  SensorView view;
  view.model = model;
  view.state = &state;
  const RayMarks marks = ray_marks(view, true, {0, 1e3}, look(true), spacing);
  EXPECT_EQ(marks.dots.size(), marks.hits.size());
  std::vector<glm::vec3> ends;
  for (const Segment& hit : marks.hits) ends.push_back(hit.b);
  return {ends, marks.misses.size()};
}

// At most one ray is drawn per pixel, and at least one overall. Zooming in keeps these rays and adds others.
TEST(RayMarks, AreThinnedIfTheyCoverEachOther) {
  const auto [near, near_misses] = shown_rays(3.0);
  EXPECT_EQ(near.size(), 400U);
  EXPECT_EQ(near_misses, 100U);
  const auto [far, far_misses] = shown_rays(0.5);
  EXPECT_GT(far.size(), 400U / 16);
  EXPECT_LE(far.size(), 400U / 4 + 20);
  EXPECT_GT(far_misses, 0U);
  EXPECT_LE(far_misses, 100U / 4 + 10);
  for (const glm::vec3& end : far) EXPECT_TRUE(std::find(near.begin(), near.end(), end) != near.end());
  EXPECT_GE(shown_rays(1e-3).first.size(), 1U);
  EXPECT_LE(shown_rays(1e-3).first.size(), 5U);
}

double area_of(const SkinWeights& skin) {
  double area = 0;
  for (const auto& t : skin.triangles) {
    const auto at = [&](std::size_t c) { return dvec3(skin.points[static_cast<std::size_t>(t[c])]); };
    area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  return area;
}

TEST(SkinWeights, CoverTheReceptiveFields) {
  const SensorModelPtr model = ball_model(0.01);
  const SkinWeights skin = skin_weights(*model);
  const Coverage coverage = make_coverage(*model, 200'000);
  EXPECT_NEAR(area_of(skin), coverage.area - coverage.uncovered(), 0.004 * coverage.area);
  EXPECT_EQ(skin.first.size(), skin.points.size() + 1);
}

// Weights are (r - d)^2 over their sum. The test computes them directly at every point that is not on a cut edge.
TEST(SkinWeights, SpreadReadingsByTheWeightsOfTheFields) {
  const SensorModelPtr model = ball_model(0.01);
  const SkinWeights skin = skin_weights(*model);
  const std::vector<double> readings{1e4, 3e4, 2e3};
  std::vector<float> values, constant;
  skin.spread(readings, values);
  skin.spread(std::vector<double>{7e3, 7e3, 7e3}, constant);
  int shared = 0, far = 0;
  for (std::size_t i = 0; i < skin.points.size(); ++i) {
    EXPECT_NEAR(constant[i], 7e3f, 0.01f);
    double sum = 0, weights = 0, margin = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Taxel& taxel = model->layout.taxels[k];
      const double d = glm::distance(taxel.center, dvec3(skin.points[i]));
      if (std::abs(d - taxel.radius) < margin) margin = std::abs(d - taxel.radius);
      if (d > taxel.radius) continue;
      const double w = (taxel.radius - d) * (taxel.radius - d);
      sum += w * readings[k];
      weights += w;
      shared += k == 1 && skin.first[i + 1] - skin.first[i] == 2 ? 1 : 0;
    }
    if (margin < 2e-4) continue;
    ++far;
    EXPECT_NEAR(static_cast<double>(values[i]), sum / weights, 1e-3 * 3e4) << i;
  }
  EXPECT_GT(shared, 100);
  EXPECT_GT(far, 1000);
}

TEST(SkinWeights, FollowTheSkinByGeodesicDistance) {
  auto model = std::make_shared<SensorModel>(*ball_model(0.01));
  model->layout.receptive_field.metric = Metric::geodesic;
  const SkinWeights skin = skin_weights(*model);
  const Coverage coverage = make_coverage(*model, 200'000);
  EXPECT_NEAR(area_of(skin), coverage.area - coverage.uncovered(), 0.006 * coverage.area);
}

}  // namespace
}  // namespace taxel::ui
