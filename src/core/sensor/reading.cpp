#include "core/sensor/reading.h"

#include "core/base/error.h"

namespace taxel {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Sum of the weights of one taxel's row with and without pressure; each aggregate is a quotient or a pick of these.
double read_taxel(const SensorModel& model, const std::vector<RayHit>& hits, Aggregate how, int taxel) {
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  double sum = 0.0, weights = 0.0, best = 0.0;
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (int e = model.fields.first[index(taxel)]; e < model.fields.first[index(taxel) + 1]; ++e) {
    const RayHit& hit = hits[index(model.ray_of_entry[index(e)])];
    if (omit_misses && !hit.hit()) continue;
    const ReceptiveFields::Entry& entry = model.fields.entries[index(e)];
    switch (how) {
      case Aggregate::weighted_mean:
      case Aggregate::weighted_sum:
        sum += entry.weight * hit.pressure;
        weights += entry.weight;
        break;
      case Aggregate::mean: {
        const double share = model.sample_share(entry.sample);
        sum += share * hit.pressure;
        weights += share;
        break;
      }
      case Aggregate::nearest:
        if (entry.distance < nearest_distance) nearest_distance = entry.distance, best = hit.pressure;
        break;
      case Aggregate::max:
        best = std::max(best, hit.pressure);
        break;
      case Aggregate::force:
        throw Error("", "/readout/aggregate", "\"force\" is not available yet");
    }
  }
  if (how == Aggregate::nearest || how == Aggregate::max) return best;
  if (how == Aggregate::weighted_sum) return sum;
  return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace

void aggregate(const SensorModel& model, const std::vector<RayHit>& hits, Aggregate how,
               std::vector<double>& readings) {
  readings.resize(index(model.taxel_count()));
  for (int k = 0; k < model.taxel_count(); ++k) readings[index(k)] = read_taxel(model, hits, how, k);
}

void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out) {
  out.caster.build(surfaces);
  cast_rays(model, out.caster, out.hits);
  aggregate(model, out.hits, model.layout.readout.aggregate, out.values);
}

}  // namespace taxel
