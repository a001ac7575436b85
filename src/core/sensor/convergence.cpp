#include "core/sensor/convergence.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace taxel {

ConvergenceModels make_convergence_models(const SensorModelPtr& model, SensorCache& cache, Progress* progress) {
  const double most = Convergence::kFactors.back() * model->layout.sampling.density * model->sampled_area;
  if (!(most <= kMaxSamples))
    throw Error("", "/sampling/density",
                fmt::format("{} times the samples are {:.4g}, the limit is {}", Convergence::kFactors.back(), most,
                            kMaxSamples));
  ConvergenceModels models;
  SensorBuild how(progress);
  how.cache = &cache;
  how.quality = model->quality;
  for (std::size_t i = 0; i < models.size(); ++i) {
    models[i] = model;
    if (i == Convergence::kAsked) continue;
    Layout layout = model->layout;
    layout.sampling.density *= Convergence::kFactors[i];
    models[i] = build_sensor_model(layout, model->loaded, "", layout.name, how);
  }
  return models;
}

Convergence read_convergence(const ConvergenceModels& models, std::span<const ContactSurface* const> surfaces) {
  Convergence convergence;
  convergence.aggregate = models[Convergence::kAsked]->layout.readout.aggregate;
  SensorReading reading;
  for (std::size_t i = 0; i < models.size(); ++i) {
    read_sensor(*models[i], surfaces, reading);
    convergence.samples[i] = static_cast<int>(models[i]->samples.size());
    convergence.values[i] = reading.values;
  }
  return convergence;
}

}  // namespace taxel
