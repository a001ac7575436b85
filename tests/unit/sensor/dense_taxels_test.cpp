// Taxels with their own density of samples: whose samples grow, whose bars fall, and whose readings keep their bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hydro/intersect.h"
#include "core/layout/words.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

constexpr double kUsual = 1e6, kDense = 16e6;
constexpr std::size_t kMiddle = 2;  // index of the taxel with more samples

/// Returns a finger with five taxels in a row, of which neighbours overlap.
Layout row_layout(const TriMeshPtr& finger, double middle_density) {
  Layout layout = test::layout_of(FieldKind::pad, kUsual, SampleWeights::equal);
  test::add_row(layout, finger);
  layout.taxels[kMiddle].density = middle_density;
  return layout;
}

/// Returns the contact surfaces of a ball at places along the row.
std::vector<ContactSurface> presses_along(const SensorModel& model) {
  std::vector<ContactSurface> presses;
  const HydroBodyPtr ball = test::rigid_ball(0.006);
  IntersectWorkspace workspace;
  for (int i = -24; i <= 24; ++i)
    intersect(*model.body, *ball, Pose{}, {dquat(1, 0, 0, 0), dvec3(0.0124, 0.0002 * (i % 3), 0.0005 * i)},
              presses.emplace_back(), workspace);
  return presses;
}

std::vector<double> readings_of(const SensorModel& model, const ContactSurface& surface) {
  const ContactSurface* list[] = {&surface};
  SensorReading reading;
  read_sensor(model, list, reading);
  return reading.values;
}

int samples_of(const SensorModel& model, std::size_t taxel) {
  return model.fields.first[taxel + 1] - model.fields.first[taxel];
}

TEST(DenseTaxels, GetMoreSamplesWhileFarTaxelsKeepTheirBits) {
  const TriMeshPtr finger = test::finger_mesh();
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    Layout layout = row_layout(finger, 0);
    layout.receptive_field.metric = metric;
    const SensorModelPtr usual = build_sensor_model(layout, finger, "", "finger");
    layout.taxels[kMiddle].density = kDense;
    const SensorModelPtr dense = build_sensor_model(layout, finger, "", "finger");
    layout.taxels[kMiddle].density = 0;
    layout.sampling.density = kDense;
    const int expected = samples_of(*build_sensor_model(layout, finger, "", "finger"), kMiddle);
    EXPECT_NEAR(samples_of(*dense, kMiddle), expected, 0.04 * expected) << "as with this density everywhere";
    double largest = 0;
    for (const ContactSurface& surface : presses_along(*usual)) {
      const std::vector<double> before = readings_of(*usual, surface), after = readings_of(*dense, surface);
      for (const std::size_t far : {std::size_t{0}, std::size_t{4}}) {
        EXPECT_EQ(samples_of(*dense, far), samples_of(*usual, far));
        EXPECT_EQ(before[far], after[far]);
        largest = std::max(largest, after[far]);
      }
    }
    EXPECT_GT(largest, 1000);
  }
}

/// Errors of samples over all presses, for one taxel.
struct Errors {
  double bar = 0;             ///< largest bar
  double peak = 0;            ///< largest exact reading
  double sum = 0, exact = 0;  ///< sums of the errors and of the exact readings
};

void add_errors(const Layout& layout, const TriMeshPtr& finger, std::size_t taxel, Errors& out) {
  const SensorModelPtr model = build_sensor_model(layout, finger, "", "finger");
  SamplingError errors(model);
  SensorReading reading;
  for (const ContactSurface& surface : presses_along(*model)) {
    const ContactSurface* list[] = {&surface};
    read_sensor(*model, list, reading);
    errors.measure(list, reading.hits.all(), reading.values);
    out.bar = std::max(out.bar, errors.bars()[taxel]);
    out.peak = std::max(out.peak, errors.exact()[taxel]);
    out.sum += std::abs(reading.values[taxel] - errors.exact()[taxel]);
    out.exact += errors.exact()[taxel];
  }
}

// The bar falls as it does with this density everywhere, and below 1 % with enough samples.
TEST(DenseTaxels, HaveTheBarsOfTheirDensity) {
  const TriMeshPtr finger = test::finger_mesh();
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean}) {
    Layout layout = row_layout(finger, 0);
    layout.readout.aggregate = how;
    Errors usual, dense, everywhere;
    add_errors(layout, finger, kMiddle, usual);
    layout.taxels[kMiddle].density = 64 * kUsual;
    add_errors(layout, finger, kMiddle, dense);
    layout.taxels[kMiddle].density = 0;
    layout.sampling.density = 64 * kUsual;
    add_errors(layout, finger, kMiddle, everywhere);
    EXPECT_GT(usual.bar, 0.02 * usual.peak) << to_word(how);
    EXPECT_LT(dense.bar, 1.5 * everywhere.bar + 0.002 * dense.peak) << to_word(how);
    if (how == Aggregate::weighted_mean) {
      EXPECT_LT(dense.bar, 0.01 * dense.peak);
    }
  }
}

// Half of the field of a neighbour is dense: the errors of its readings, over eight seeds, fall.
TEST(DenseTaxels, DoNotSpoilTaxelsThatOverlap) {
  const TriMeshPtr finger = test::finger_mesh();
  for (const SampleWeights weights : {SampleWeights::equal, SampleWeights::voronoi})
    for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean, Aggregate::weighted_sum}) {
      Layout layout = row_layout(finger, 0);
      layout.readout.aggregate = how;
      layout.sampling.weights = weights;
      double usual = 0;
      for (const double factor : {1.0, 2.0, 16.0}) {
        Errors errors;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
          layout.sampling.seed = seed;
          layout.taxels[kMiddle].density = factor * kUsual;
          add_errors(layout, finger, kMiddle + 1, errors);
        }
        if (factor == 1)
          usual = errors.sum;
        else
          EXPECT_LT(errors.sum, 0.98 * usual) << to_word(how) << " " << to_word(weights) << " " << factor;
      }
    }
}

TEST(DenseTaxels, GrowWithTheOthersInMoreSamples) {
  const TriMeshPtr finger = test::finger_mesh();
  const SensorModelPtr model = build_sensor_model(row_layout(finger, 4 * kUsual), finger, "", "finger");
  SensorCache cache;
  const SensorModelPtr four = with_samples_times(4, model, cache, nullptr);
  for (const std::size_t k : {std::size_t{0}, kMiddle})
    EXPECT_NEAR(samples_of(*four, k), 4 * samples_of(*model, k), 0.08 * samples_of(*four, k)) << k;
}

// A cache gives the samples of a build without one, also after the region and the density have changed.
TEST(DenseTaxels, AreEqualWithAndWithoutCache) {
  const TriMeshPtr finger = test::finger_mesh();
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  Layout layout = row_layout(finger, 4 * kUsual);
  std::vector<int> side;
  for (int f = 0; f < finger->face_count(); ++f)
    if (finger->vertex(f, 0).x > 0) side.push_back(f);
  layout.sampling.region = side;
  for (const double density : {4 * kUsual, 9 * kUsual, 0.0, 4 * kUsual}) {
    layout.taxels[kMiddle].density = density;
    const SensorModelPtr cached = build_sensor_model(layout, finger, "", "finger", how);
    const SensorModelPtr fresh = build_sensor_model(layout, finger, "", "finger");
    ASSERT_EQ(cached->samples.size(), fresh->samples.size());
    for (std::size_t i = 0; i < fresh->samples.size(); ++i) {
      ASSERT_EQ(cached->samples[i].position, fresh->samples[i].position);
      ASSERT_EQ(cached->samples[i].face, fresh->samples[i].face);
      ASSERT_EQ(cached->samples[i].share, fresh->samples[i].share);
      ASSERT_EQ(fresh->samples[i].normal,
                fresh->skin->mesh().face_normals()[static_cast<std::size_t>(fresh->samples[i].face)]);
    }
  }
}

}  // namespace
}  // namespace taxel
