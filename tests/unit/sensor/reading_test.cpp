// The readings of hits: the formulas term by term, and a patch with a known integral.
#include "core/sensor/readout/reading.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/explain/explanation.h"
#include "core/sensor/readout/aggregate.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

/// A model of five taxels over 200 samples with random fields (the last one empty) and hits, a third of which are
/// misses.
struct Fixture {
  SensorModel model;
  RayHits hits;
  explicit Fixture(std::uint64_t seed, SampleWeights weights = SampleWeights::equal) {
    const CounterRng rng(seed);
    std::uint64_t next = 0;
    const auto mesh = std::make_shared<TriMesh>(make_box(dvec3(0.01)));
    model.skin = std::make_shared<MeshIndex>(mesh);
    model.sampled_area = mesh->area();
    model.layout.sampling.weights = weights;
    model.layout.taxels.resize(5);
    hits.clear(200);
    for (int i = 0; i < 200; ++i) {
      model.samples.push_back({dvec3(0), dvec3(0, 0, 1), 0, mesh->area() / 200 * (0.5 + rng.uniform(next++))});
      model.rays.push_back({i, dvec3(0), dvec3(0, 0, 1), 1.0});
      const bool miss = rng.uniform(next++) < 0.3;
      if (!miss) hits.offer(i, {0, i, 0.001 * rng.uniform(next), 1e4 * rng.uniform(next + 1)});
      next += 2;
    }
    std::vector<int> ray_of_entry;
    for (int k = 0; k < 5; ++k) {
      for (int i = 0; k < 4 && i < 200; ++i) {
        if (rng.uniform(next++) < 0.7) continue;
        const double d = 0.006 * rng.uniform(next++);
        model.fields.entries.push_back({i, d, (0.006 - d) * (0.006 - d) * model.sample_share(i)});
        ray_of_entry.push_back(i);
      }
      model.fields.first.push_back(static_cast<int>(model.fields.entries.size()));
    }
    hits.finish();
    model.readout_table = make_readout_table(model.fields, ray_of_entry, model.ray_shares());
  }
};

/// Computes the aggregates by their definitions, term by term, in long double.
double direct(const Fixture& f, Aggregate how, Misses misses, std::size_t k) {
  long double sum_wp = 0, sum_w = 0, sum_ap = 0, sum_a = 0, best = 0, nearest = 0, distance = 1e9L;
  for (int e = f.model.fields.first[k]; e < f.model.fields.first[k + 1]; ++e) {
    const ReceptiveFields::Entry& entry = f.model.fields.entries[static_cast<std::size_t>(e)];
    const RayHit& hit = f.hits[entry.sample];
    if (misses == Misses::omit && hit.surface < 0) continue;
    const long double p = hit.pressure, w = entry.weight;
    const double area = f.model.samples[static_cast<std::size_t>(entry.sample)].area;
    const bool voronoi = f.model.layout.sampling.weights == SampleWeights::voronoi;
    const long double a = voronoi ? area * 200.0L / f.model.skin->mesh().area() : 1.0L;
    sum_wp += w * p, sum_w += w, sum_ap += a * p, sum_a += a;
    best = std::max(best, p);
    if (entry.distance < distance) distance = entry.distance, nearest = p;
  }
  switch (how) {
    case Aggregate::weighted_mean:
      return static_cast<double>(sum_w > 0 ? sum_wp / sum_w : 0);
    case Aggregate::weighted_sum:
      return static_cast<double>(sum_wp);
    case Aggregate::mean:
      return static_cast<double>(sum_a > 0 ? sum_ap / sum_a : 0);
    case Aggregate::nearest:
      return static_cast<double>(nearest);
    default:
      return static_cast<double>(best);
  }
}

constexpr Aggregate kSampled[] = {Aggregate::weighted_mean, Aggregate::weighted_sum, Aggregate::mean,
                                  Aggregate::nearest, Aggregate::max};

TEST(Aggregate, EqualsTheFormulas) {
  for (const SampleWeights weights : {SampleWeights::equal, SampleWeights::voronoi}) {
    for (const Misses misses : {Misses::zero, Misses::omit}) {
      for (const Aggregate how : kSampled) {
        Fixture f(3, weights);
        f.model.layout.readout.misses = misses;
        std::vector<double> readings(99, -1.0);
        aggregate(f.model, f.hits, how, readings);
        ASSERT_EQ(readings.size(), 5U);
        for (std::size_t k = 0; k < 5; ++k) {
          const double expected = direct(f, how, misses, k);
          EXPECT_NEAR(readings[k], expected, 1e-12 * std::abs(expected)) << static_cast<int>(how) << " " << k;
        }
        EXPECT_GT(readings[0], 0.0);
        EXPECT_EQ(readings[4], 0.0) << "a taxel without samples reads 0";
      }
    }
  }
}

TEST(Aggregate, RaisesAMeanIfMissesAreOmitted) {
  Fixture f(3);
  std::vector<double> zero, omit;
  aggregate(f.model, f.hits, Aggregate::weighted_mean, zero);
  f.model.layout.readout.misses = Misses::omit;
  aggregate(f.model, f.hits, Aggregate::weighted_mean, omit);
  EXPECT_GT(omit[0], 1.1 * zero[0]);
}

TEST(Aggregate, ReadsZeroIfAllRaysMiss) {
  Fixture f(3);
  f.hits.clear(200);
  for (const Misses misses : {Misses::zero, Misses::omit})
    for (const Aggregate how : kSampled) {
      f.model.layout.readout.misses = misses;
      std::vector<double> readings;
      aggregate(f.model, f.hits, how, readings);
      EXPECT_EQ(readings, std::vector<double>(5, 0.0));
    }
}

TEST(SamplesBehind, HaveSharesThatAddUpToTheReading) {
  for (const Aggregate how : kSampled) {
    Fixture f(8);
    f.model.layout.readout.aggregate = how;
    std::vector<double> readings;
    aggregate(f.model, f.hits, how, readings);
    for (int k = 0; k < 4; ++k) {
      const std::vector<TaxelSampleReading> rows = samples_behind(f.model, f.hits.all(), k);
      double shares = 0.0, sum_wp = 0.0, sum_w = 0.0, picked = 0.0;
      for (const TaxelSampleReading& r : rows) {
        const RayHit& hit = f.hits[r.sample];
        EXPECT_EQ(r.hit, hit.hit());
        EXPECT_EQ(r.depth, hit.depth);
        EXPECT_EQ(r.pressure, hit.pressure);
        shares += r.share, sum_wp += r.weight * r.pressure, sum_w += r.weight, picked += r.share * r.pressure;
      }
      const double reading = readings[static_cast<std::size_t>(k)];
      if (reading > 0.0) {
        EXPECT_NEAR(shares, 1.0, 1e-12);
      }
      if (how == Aggregate::weighted_mean) {
        EXPECT_NEAR(sum_wp / sum_w, reading, 1e-12 * reading);
      }
      if (how == Aggregate::nearest || how == Aggregate::max) {
        EXPECT_NEAR(picked, reading, 1e-12 * reading);
      }
    }
    EXPECT_TRUE(samples_behind(f.model, f.hits.all(), 4).empty());
    EXPECT_THROW(samples_behind(f.model, f.hits.all(), 5), Error);
    EXPECT_THROW(samples_behind(f.model, f.hits.all(), -1), Error);
  }
}

TEST(AggregateSpec, HasTheFormulasOfEachRow) {
  for (std::size_t i = 0; i < std::size(kAggregates); ++i) {
    const AggregateRow& row = kAggregates[i];
    EXPECT_EQ(static_cast<std::size_t>(row.value), i) << row.text;
    const AggregateSpec& spec = aggregate_spec(row.value);
    EXPECT_EQ(spec.fold == nullptr, spec.fold_friction == nullptr) << row.text;
    EXPECT_NE(spec.contribution == nullptr, spec.rank == nullptr) << row.text;
    EXPECT_NE(spec.exact, nullptr) << row.text;
  }
  EXPECT_EQ(aggregate_spec(Aggregate::force).fold, nullptr);
  EXPECT_TRUE(aggregate_spec(Aggregate::weighted_sum).grows_with_samples);
}

/// Returns a model with a taxel of 6 mm on the upper face of a plate, far from its edges.
SensorModelPtr patch_model(double density) {
  Layout layout;
  layout.mesh.file = "plate";
  layout.sampling.density = density;
  layout.readout.max_depth = 0.002;
  layout.taxels = {{0, "", dvec3(0.001, 0.002, 0.002), dvec3(0, 0, 1), 0.006, {}}};
  return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "patch");
}

/// Returns a surface for x > `from`, 1 mm below this face, with a linear pressure.
ContactSurface patch(double from, const dvec3& slope) {
  ContactSurface surface;
  const double y = 0.01, z = 0.001;
  add_polygon(surface, {dvec3(from, -y, z), dvec3(y, -y, z), dvec3(y, y, z), dvec3(from, y, z)}, 2e4, slope);
  return surface;
}

double read_patch(const SensorModel& model, Aggregate how, const ContactSurface& surface) {
  SensorReading reading;
  const ContactSurface* list[] = {&surface};
  read_sensor(model, list, reading);
  std::vector<double> values;
  aggregate(model, reading.hits, how, values);
  return values.at(0);
}

// Odd terms cancel over the disc, so the weighted mean of a linear pressure is the pressure below the centre. The error
// is that of the quadrature and decreases with the density.
TEST(Reading, GivesTheCentrePressureAsMeanOfALinearPressure) {
  const dvec3 slope(1.5e6, -4e5, 0);
  const double exact = 2e4 + slope.x * 0.001 + slope.y * 0.002;
  const auto error = [&](double density) {
    return std::abs(read_patch(*patch_model(density), Aggregate::weighted_mean, patch(-0.01, slope)) / exact - 1.0);
  };
  EXPECT_LT(error(1e6), 0.02);
  EXPECT_LT(error(1e7), 0.004);
}

// If half of the disc is covered, the mean is half of the pressure. The sum is samples per area times p times the
// integral of (r - d)^2, which is pi r^4 / 6. A plane has slightly more samples per area than the mean, sharp edges
// have slightly fewer.
TEST(Reading, EqualsTheClosedFormForPartialCover) {
  const double p = 2e4, r = 0.006, density = 4e6;
  const SensorModelPtr model = patch_model(density);
  const ContactSurface half = patch(0.001, dvec3(0)), whole = patch(-0.01, dvec3(0));
  EXPECT_NEAR(read_patch(*model, Aggregate::weighted_mean, half) / p, 0.5, 0.01);
  EXPECT_NEAR(read_patch(*model, Aggregate::mean, half) / p, 0.5, 0.02);
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::mean, Aggregate::nearest, Aggregate::max})
    EXPECT_NEAR(read_patch(*model, how, whole) / p, 1.0, 1e-12);
  const double sum = density * p * kPi * std::pow(r, 4) / 6.0;
  EXPECT_NEAR(read_patch(*model, Aggregate::weighted_sum, whole) / sum, 1.0, 0.03);
}

}  // namespace
}  // namespace taxel
