// A linear pressure over a flat patch: the limit of each aggregate and the order of convergence
// (docs/theory/sensor.md).
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/validate/setups.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

constexpr double kHalf = FlatPatch::kHalf, kThickness = FlatPatch::kThickness, kRadius = FlatPatch::kRadius;  // [m]

Layout patch_layout(double samples, std::uint64_t seed, SampleWeights weights) {
  return FlatPatch::layout(samples, seed, weights);
}
SensorModelPtr patch_model(const Layout& layout) {
  return FlatPatch::model(layout);
}

/// p = kBase + kSlope x over the whole plate, inside it: between 0.4 and 1.6 times kBase.
constexpr double kBase = 2e4, kSlope = FlatPatch::kSlope * kBase;
ContactSurface linear_pressure() {
  ContactSurface surface;
  const double a = kHalf, z = 0.2 * kThickness;
  add_polygon(surface, {dvec3(-a, -a, z), dvec3(a, -a, z), dvec3(a, a, z), dvec3(-a, a, z)}, kBase,
              dvec3(kSlope, 0, 0));
  return surface;
}
double pressure_at(double x) {
  return kBase + kSlope * x;
}

/// Returns the limit of an aggregate by integrals over the disc about the taxel's centre c:
///   weighted_mean, mean: p(c), because odd terms cancel; nearest: p(c); max: p at the rim, c + r along the slope;
///   weighted_sum: N/A times the integral of (r - d)^2 p = N/A p(c) pi r^4 / 6.
double integral_of(const SensorModel& model, Aggregate how, std::size_t k) {
  const double x = model.layout.taxels[k].center.x;
  if (how == Aggregate::max) return pressure_at(x + kRadius);
  if (how != Aggregate::weighted_sum) return pressure_at(x);
  const double density = static_cast<double>(model.samples.size()) / model.skin->mesh().area();
  return density * pressure_at(x) * kPi * std::pow(kRadius, 4) / 6.0;
}

/// Returns the relative error as a root mean square over the 49 taxels.
double error_of(const SensorModel& model, Aggregate how) {
  const ContactSurface surface = linear_pressure();
  const ContactSurface* list[] = {&surface};
  SensorReading reading;
  read_sensor(model, list, reading);
  std::vector<double> values;
  aggregate(model, reading.hits, how, values);
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) sum += std::pow(values[k] / integral_of(model, how, k) - 1.0, 2);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Returns the distance of the weighted centre of a taxel's samples from the taxel's centre, relative to the radius.
/// This is the relative error of a weighted mean under the steepest pressure that stays positive over the field, p = p0
/// (1 + x/r), in the worst direction of x.
double worst_error(const SensorModel& model, std::size_t k, SampleWeights weights) {
  dvec3 moment(0);
  double sum = 0;
  for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
    const auto& entry = model.fields.entries[static_cast<std::size_t>(e)];
    const double equal = (kRadius - entry.distance) * (kRadius - entry.distance);
    const double weight = weights == SampleWeights::equal ? equal : entry.weight;
    moment += weight * (model.samples[static_cast<std::size_t>(entry.sample)].position - model.layout.taxels[k].center);
    sum += weight;
  }
  return glm::length(moment / sum) / kRadius;
}

// 100 samples per taxel, Voronoi weights, the steepest slope in its worst direction, 49 taxels of 20 seeds.
TEST(LinearPressure, IsReadWithinHalfAPercentByVoronoiWeights) {
  double sum = 0, worst = 0, equal_sum = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SensorModelPtr model = patch_model(patch_layout(100, seed, SampleWeights::voronoi));
    for (std::size_t k = 0; k < 49; ++k, ++count) {
      const int samples = model->fields.first[k + 1] - model->fields.first[k];
      ASSERT_NEAR(samples, 100, 15);
      const double error = worst_error(*model, k, SampleWeights::voronoi);
      sum += error, worst = std::max(worst, error), equal_sum += worst_error(*model, k, SampleWeights::equal);
    }
  }
  RecordProperty("mean_error", std::to_string(sum / count));
  RecordProperty("worst_error", std::to_string(worst));
  RecordProperty("mean_error_equal_weights", std::to_string(equal_sum / count));
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(sum / count, 0.001);
  EXPECT_LT(sum, 0.7 * equal_sum);
}

// Root mean square of the error over 49 taxels and 3 seeds, against the number of samples n in a field: the order is
// fitted between n = 25 and 400.
TEST(LinearPressure, IsReadWithTheOrderOfEachAggregate) {
  struct Case {
    Aggregate how;
    SampleWeights weights;
    double order;
  };
  // Equal weights have an error by the lower density of samples near the plate's edges, for any number of samples.
  const Case cases[] = {
      {Aggregate::weighted_mean, SampleWeights::voronoi, 1.25}, {Aggregate::weighted_sum, SampleWeights::voronoi, 1.25},
      {Aggregate::mean, SampleWeights::voronoi, 0.75},          {Aggregate::weighted_mean, SampleWeights::equal, 0.25},
      {Aggregate::weighted_sum, SampleWeights::equal, 0.25},    {Aggregate::mean, SampleWeights::equal, 0.5},
      {Aggregate::nearest, SampleWeights::equal, 0.5},          {Aggregate::max, SampleWeights::equal, 0.667}};
  constexpr double kSamples[] = {25.0, 100.0, 400.0};
  std::array<std::array<double, 3>, std::size(cases)> squares{};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const SampleWeights weights : {SampleWeights::equal, SampleWeights::voronoi}) {
      for (std::size_t i = 0; i < 3; ++i) {
        const SensorModelPtr model = patch_model(patch_layout(kSamples[i], seed, weights));
        for (std::size_t c = 0; c < std::size(cases); ++c)
          if (cases[c].weights == weights) squares[c][i] += std::pow(error_of(*model, cases[c].how), 2) / 3.0;
      }
    }
  }
  for (std::size_t c = 0; c < std::size(cases); ++c) {
    const double order = 0.5 * std::log(squares[c][0] / squares[c][2]) / std::log(16.0);
    EXPECT_GT(order, 0.9 * cases[c].order) << "case " << c;
  }
}

// Compares rays and aggregates together with the definitions, term by term, with the pressures at the samples.
TEST(LinearPressure, IsReadByTheDefinitionOfEachAggregate) {
  for (const SampleWeights weights : {SampleWeights::equal, SampleWeights::voronoi}) {
    const SensorModelPtr model = patch_model(patch_layout(100, 5, weights));
    const ContactSurface surface = linear_pressure();
    const ContactSurface* list[] = {&surface};
    SensorReading reading;
    read_sensor(*model, list, reading);
    double mean_area = 0;
    for (const SurfaceSample& s : model->samples) mean_area += s.area / static_cast<double>(model->samples.size());
    for (std::size_t k = 0; k < 49; ++k) {
      const Taxel& taxel = model->layout.taxels[k];
      long double wp = 0, w = 0, ap = 0, a = 0, largest = 0, nearest = 0, least = 1e9L;
      for (const SurfaceSample& s : model->samples) {
        const double d = glm::distance(s.position, taxel.center);
        if (d > taxel.radius || s.normal.z < 0.9) continue;
        const long double share = weights == SampleWeights::voronoi ? s.area / mean_area : 1.0;
        const long double p = pressure_at(s.position.x), weight = share * (taxel.radius - d) * (taxel.radius - d);
        wp += weight * p, w += weight, ap += share * p, a += share;
        largest = std::max(largest, p);
        if (d < least) least = d, nearest = p;
      }
      const std::pair<Aggregate, long double> expected[] = {{Aggregate::weighted_mean, wp / w},
                                                            {Aggregate::weighted_sum, wp},
                                                            {Aggregate::mean, ap / a},
                                                            {Aggregate::nearest, nearest},
                                                            {Aggregate::max, largest}};
      for (const auto& [how, value] : expected) {
        std::vector<double> values;
        aggregate(*model, reading.hits, how, values);
        EXPECT_NEAR(values[k], static_cast<double>(value), 1e-12 * static_cast<double>(value)) << static_cast<int>(how);
      }
    }
  }
}

struct ReadAll {
  SensorModelPtr model;
  std::vector<std::pair<Aggregate, std::vector<double>>> values;
  explicit ReadAll(const Layout& layout) : model(patch_model(layout)) {
    const ContactSurface surface = linear_pressure();
    const ContactSurface* list[] = {&surface};
    SensorReading reading;
    read_sensor(*model, list, reading);
    for (const Aggregate how :
         {Aggregate::weighted_mean, Aggregate::weighted_sum, Aggregate::mean, Aggregate::nearest, Aggregate::max}) {
      values.emplace_back(how, std::vector<double>());
      aggregate(*model, reading.hits, how, values.back().second);
    }
  }
};

// Samples, fields and readings have the same bits with 1, 2 and 8 threads.
TEST(Reading, IsTheSameForAnyNumberOfThreads) {
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    Layout layout = patch_layout(100, 5, SampleWeights::voronoi);
    layout.receptive_field.metric = metric;
    std::vector<ReadAll> all;
    for (const std::size_t threads : {1U, 2U, 8U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      all.emplace_back(layout);
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
      EXPECT_EQ(all[i].values, all[0].values);
      ASSERT_EQ(all[i].model->samples.size(), all[0].model->samples.size());
      for (std::size_t s = 0; s < all[0].model->samples.size(); ++s)
        ASSERT_EQ(all[i].model->samples[s].position, all[0].model->samples[s].position);
    }
  }
}

// The bits of a taxel's reading do not depend on its place in the layout, with rays by sample and with rays by entry.
TEST(Reading, IsTheSameForAnyOrderOfTheTaxels) {
  for (const RayDirection ray : {RayDirection::surface_normal, RayDirection::taxel_normal}) {
    Layout layout = patch_layout(100, 5, SampleWeights::voronoi);
    layout.readout.ray = ray;
    const ReadAll before(layout);
    const CounterRng rng(11);
    for (std::size_t i = layout.taxels.size(); i > 1; --i)
      std::swap(layout.taxels[i - 1], layout.taxels[static_cast<std::size_t>(rng.uniform(i) * static_cast<double>(i))]);
    const ReadAll after(layout);
    int moved = 0;
    for (std::size_t a = 0; a < before.values.size(); ++a)
      for (std::size_t k = 0; k < layout.taxels.size(); ++k) {
        const auto id = static_cast<std::size_t>(layout.taxels[k].id);
        EXPECT_EQ(after.values[a].second[k], before.values[a].second[id]) << "taxel " << id;
        moved += id != k;
      }
    EXPECT_GT(moved, 100);
  }
}

}  // namespace
}  // namespace taxel
