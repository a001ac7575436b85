#include "core/sensor/convergence.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/layout/field/dense_fields.h"

namespace taxel {

SensorModelPtr with_samples_times(double factor, const SensorModelPtr& model, SensorCache& cache, Progress* progress) {
  const double samples = factor * model->layout.sampling.density * model->sampled_area;
  if (!(samples <= kMaxSamples))
    throw Error("", "/sampling/density",
                fmt::format("{} times the samples are {:.4g}, the limit is {}", factor, samples, kMaxSamples));
  SensorBuild how(progress);
  how.cache = &cache;
  how.quality = model->quality;
  Layout layout = model->layout;
  multiply_densities(layout, factor);
  return build_sensor_model(layout, model->loaded, "", layout.name, how);
}

ConvergenceModels make_convergence_models(const SensorModelPtr& model, SensorCache& cache, Progress* progress) {
  ConvergenceModels models;
  models[Convergence::kAsked] = model;
  for (std::size_t i = models.size(); i-- > 0;)  // the largest first, because only it can have too many samples
    if (i != Convergence::kAsked) models[i] = with_samples_times(Convergence::kFactors[i], model, cache, progress);
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
