// A contact with fewer and with more samples, compared with separately built sensors.
#include "core/sensor/error_bars.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"
#include "unit/sensor/random_surface.h"

namespace taxel {
namespace {

struct Plate {
  Layout layout;
  TriMeshPtr mesh = std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002)));
  ContactSurface surface;
  Plate(double base, const dvec3& slope) {
    layout.mesh.file = "plate";
    layout.sampling.density = 1e6;
    layout.readout.max_depth = 0.002;
    layout.taxels = {{7, "", dvec3(0.001, 0.002, 0.002), dvec3(0, 0, 1), 0.004, {}},
                     {3, "", dvec3(-0.005, 0, 0.002), dvec3(0, 0, 1), 0.003, {}}};
    const double a = 0.01, z = 0.001;
    add_polygon(surface, {dvec3(-a, -a, z), dvec3(a, -a, z), dvec3(a, a, z), dvec3(-a, a, z)}, base, slope);
  }
  [[nodiscard]] SensorModelPtr build(double factor, SensorCache* cache = nullptr) const {
    Layout own = layout;
    own.sampling.density *= factor;
    SensorBuild how;
    how.cache = cache;
    return build_sensor_model(own, mesh, "", "plate", how);
  }
  [[nodiscard]] Convergence read(SensorCache& cache) const {
    const ContactSurface* list[] = {&surface};
    return read_convergence(make_convergence_models(build(1.0, &cache), cache), list);
  }
};

TEST(Convergence, EqualsSeparatelyBuiltSensors) {
  Plate plate(2e4, dvec3(1.5e6, -4e5, 0));
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::weighted_sum}) {
    plate.layout.readout.aggregate = how;
    SensorCache cache;
    const Convergence found = plate.read(cache);
    EXPECT_EQ(found.aggregate, how);
    for (std::size_t i = 0; i < 3; ++i) {
      const SensorModelPtr model = plate.build(Convergence::kFactors[i]);
      const ContactSurface* list[] = {&plate.surface};
      SensorReading reading;
      read_sensor(*model, list, reading);
      EXPECT_EQ(found.values[i], reading.values) << i;
      EXPECT_EQ(found.samples[i], static_cast<int>(model->samples.size()));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(found.difference(k), found.values[2][k] - found.values[1][k]);
      EXPECT_NE(found.difference(k), 0.0);
    }
  }
}

// The mean of a constant pressure does not depend on the samples. A sum is proportional to their number.
TEST(Convergence, IsExactForAConstantPressure) {
  Plate plate(2e4, dvec3(0));
  SensorCache cache;
  const Convergence mean = plate.read(cache);
  for (std::size_t k = 0; k < 2; ++k) {
    for (const auto& values : mean.values) EXPECT_NEAR(values[k], 2e4, 1e-12 * 2e4);
    EXPECT_NEAR(mean.difference(k), 0.0, 1e-12 * 2e4);
  }
  plate.layout.readout.aggregate = Aggregate::weighted_sum;
  const Convergence sum = plate.read(cache);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(sum.values[1][k] / sum.values[0][k], 4.0, 0.6);
    EXPECT_NEAR(sum.values[2][k] / sum.values[1][k], 4.0, 0.3);
  }
}

// Models from the cache cannot be cancelled, but models that are built can.
TEST(Convergence, BuildsNothingTwice) {
  const Plate plate(2e4, dvec3(0));
  SensorCache cache;
  const SensorModelPtr model = plate.build(1.0, &cache);
  const ContactSurface* list[] = {&plate.surface};
  read_convergence(make_convergence_models(model, cache), list);
  const SensorSkinPtr skin = cache.skin(plate.mesh, Shells::outer);
  EXPECT_EQ(skin->sensed, model->skin);
  EXPECT_EQ(cache.body(*model->repaired, plate.layout.material, kDefaultRefine, ""), model->body);
  Progress cancelled;
  cancelled.cancel();
  const auto samples = [&](double factor) {
    const int count = sample_count(factor * plate.layout.sampling.density, plate.mesh->area());
    return cache.samples(cache.sampled(skin, {}), count, plate.layout.sampling.seed, SampleQuality::polished,
                         &cancelled);
  };
  for (const double factor : Convergence::kFactors) EXPECT_NO_THROW(samples(factor)) << factor;
  EXPECT_THROW(samples(2.0), Cancelled);
}

TEST(Convergence, NamesTooManySamples) {
  Plate plate(2e4, dvec3(0));
  plate.layout.sampling.density = 2e6;
  SensorCache cache;
  const SensorModelPtr model = plate.build(1.0, &cache);
  auto denser = std::make_shared<SensorModel>(*model);
  denser->layout.sampling.density = 4e9;
  try {
    make_convergence_models(denser, cache);
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "/sampling/density: 4 times the samples are 1.792e+07, the limit is 10000000");
  }
}

}  // namespace
}  // namespace taxel
