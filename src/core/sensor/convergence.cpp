#include "core/sensor/convergence.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel {

Convergence read_convergence(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                             SensorCache& cache, Progress* progress) {
  const double most = Convergence::kFactors.back() * model.layout.sampling.density * model.sampled_area;
  if (!(most <= kMaxSamples))
    throw Error("", "/sampling/density",
                fmt::format("{} times the samples are {:.4g}, the limit is {}", Convergence::kFactors.back(), most,
                            kMaxSamples));
  Convergence convergence;
  convergence.aggregate = model.layout.readout.aggregate;
  SensorBuild how(progress);
  how.cache = &cache;
  how.quality = model.quality;
  SensorReading reading;
  for (std::size_t i = 0; i < Convergence::kFactors.size(); ++i) {
    SensorModelPtr made;
    if (i != Convergence::kAsked) {
      Layout layout = model.layout;
      layout.sampling.density *= Convergence::kFactors[i];
      made = build_sensor_model(layout, model.mesh, "", layout.name, how);
    }
    const SensorModel& level = made ? *made : model;
    read_sensor(level, surfaces, reading);
    convergence.samples[i] = static_cast<int>(level.samples.size());
    convergence.values[i] = reading.values;
  }
  return convergence;
}

}  // namespace taxel
