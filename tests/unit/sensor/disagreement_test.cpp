// The largest sampling error, compared with the exact readings of all taxels.
#include "core/sensor/error_bars.h"
#include "core/sensor/readout/reading.h"

#include <gtest/gtest.h>

#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

/// Returns a finger with a ring of taxels. A ball presses those on one side.
test::LabelledCase ring_of_taxels(double density, Aggregate how) {
  const TriMeshPtr mesh = test::egg_mesh();
  Layout layout = test::layout_of(FieldKind::pad, density);
  layout.readout.aggregate = how;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * kPi * i / 8;
    test::add_taxel(layout, mesh, 0.007 * dvec3(std::cos(angle), std::sin(angle), 0.2), 0.003);
    layout.taxels.back().id = i;
  }
  test::LabelledCase c;
  c.model = test::preview_model(layout, mesh);
  c.other = test::rigid_ball(0.003);
  c.path = {test::tap(mesh, dvec3(0.0065, 0.002, 0.001), 0.003, 0.0008)};
  return c;
}

TEST(SampleGap, IsTheLargestErrorOfAllTaxels) {
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::weighted_sum, Aggregate::mean, Aggregate::max}) {
    const test::LabelledCase c = ring_of_taxels(3e6, how);
    const auto step = c.sense(c.path[0]);
    const auto found = largest_sample_gap(*c.model, surface_pointers(step), step.readings);
    ASSERT_TRUE(found.has_value());
    double largest = 0, scale = 0;
    for (int k = 0; k < c.model->taxel_count(); ++k) {
      const double exact = *exact_reading(*c.model, k, surface_pointers(step)).value;
      const double sampled = step.readings[static_cast<std::size_t>(k)];
      scale = std::max(scale, exact);
      largest = std::max(largest, std::abs(sampled - exact));
      if (k == found->taxel) {
        EXPECT_EQ(found->sampled, sampled);
        EXPECT_NEAR(found->exact, exact, 0.011 * exact);
      }
    }
    EXPECT_GT(largest, 0.03 * scale) << "so few samples are off";
    EXPECT_NEAR(found->gap, largest, 0.022 * scale) << static_cast<int>(how);
  }
}

TEST(SampleGap, ClosesWithMoreSamples) {
  const auto gap = [](double density) {
    const test::LabelledCase c = ring_of_taxels(density, Aggregate::weighted_mean);
    const auto step = c.sense(c.path[0]);
    return largest_sample_gap(*c.model, surface_pointers(step), step.readings)->gap;
  };
  EXPECT_LT(gap(8e7), 0.2 * gap(2e6));
}

TEST(SampleGap, IncludesATaxelWhoseSamplesAllMiss) {
  const test::LabelledCase c = ring_of_taxels(3e6, Aggregate::weighted_mean);
  const auto step = c.sense(c.path[0]);
  const std::vector<double> nothing(step.readings.size(), 0.0);
  const auto found = largest_sample_gap(*c.model, surface_pointers(step), nothing);
  EXPECT_NEAR(found->exact, *exact_reading(*c.model, found->taxel, surface_pointers(step)).value, 0.011 * found->exact);
  EXPECT_GT(found->gap, 0.98 * found->exact);
  EXPECT_EQ(largest_sample_gap(*c.model, {}, nothing)->gap, 0.0);
}

TEST(SampleGap, IsEmptyIfNoSamplesAreRead) {
  const test::LabelledCase c = ring_of_taxels(3e6, Aggregate::force);
  const auto step = c.sense(c.path[0]);
  EXPECT_FALSE(largest_sample_gap(*c.model, surface_pointers(step), step.readings).has_value());
}

}  // namespace
}  // namespace taxel
