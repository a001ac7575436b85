#include "core/sensor/explain/advice.h"

#include <cmath>

#include "core/base/error.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/readout/reading.h"

namespace taxel {

double reading_of(const SensorModel& model, int taxel, const SensorStep& step) {
  SensorReading reading;
  read_sensor(model, surface_pointers(step), reading);
  return reading.values[static_cast<std::size_t>(taxel)];
}

namespace {

double change_of(const SensorModel& model, int taxel, const SensorStep& before, const SensorStep& now) {
  return reading_of(model, taxel, now) - reading_of(model, taxel, before);
}

}  // namespace

std::optional<SamplesNeeded> samples_that_cure(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                               const SensorStep& now, double limit, DenserModels& made,
                                               SensorCache& cache, Progress* progress) {
  std::optional<SamplesNeeded> tried;
  const double asked = static_cast<double>(model->samples.size());
  for (const double factor : kTriedFactors) {
    if (factor * asked > kMaxTriedSamples) break;
    SensorModelPtr& denser = made[factor];
    try {
      if (!denser) denser = with_samples_times(factor, model, cache, progress);
    } catch (const Error&) {
      break;  // the samples cannot be made
    }
    const double samples = static_cast<double>(denser->samples.size());
    double change = change_of(*denser, taxel, before, now);
    if (aggregate_spec(model->layout.readout.aggregate).grows_with_samples && samples > 0) change *= asked / samples;
    tried = SamplesNeeded{samples, factor, change, std::abs(change) <= kCureMargin * limit};
    if (tried->cures) break;
  }
  return tried;
}

SensorModel without_angle_limit(const SensorModel& model) {
  SensorModel other(model);
  other.layout.receptive_field.max_angle_deg = kTriedAngles.back();
  other.layout.receptive_field.angle_falloff_deg = 0.0;
  if (other.skin_fields != nullptr) other.skin_fields = skin_fields_for(other, integral_of(other.layout.readout));
  return other;
}

std::optional<AngleTried> angle_that_cures(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                           const SensorStep& now, double limit, SensorCache& cache,
                                           Progress* progress) {
  std::optional<AngleTried> tried;
  for (const double angle : kTriedAngles) {
    if (!(angle > model->layout.receptive_field.max_angle_deg)) continue;
    Layout layout = model->layout;
    layout.receptive_field.max_angle_deg = angle;
    SensorBuild how(progress);
    how.cache = &cache;
    how.quality = model->quality;
    try {
      const SensorModelPtr wider = build_sensor_model(layout, model->loaded, "", layout.name, how);
      const double change = change_of(*wider, taxel, before, now);
      tried = AngleTried{angle, change, std::abs(change) <= kCureMargin * limit};
    } catch (const Error&) {
      break;  // the layout cannot be compiled
    }
    if (tried->cures) break;
  }
  return tried;
}

double change_with_voronoi_weights(const SensorModel& model, int taxel, const SensorStep& before,
                                   const SensorStep& now) {
  SensorModel other(model);
  other.layout.sampling.weights = SampleWeights::voronoi;
  other.fields = make_receptive_fields(other.layout, other.samples, *other.skin);
  other.readout_table = make_readout_table(other.fields, model.readout_table.ray_of_entry, other.ray_shares());
  return change_of(other, taxel, before, now);
}

}  // namespace taxel
