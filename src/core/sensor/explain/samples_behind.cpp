#include "core/sensor/explain/samples_behind.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/index.h"

namespace taxel {
namespace {

/// What a sample brings in before the division: w p, its plain share of p, or all of p for the one that is picked.
double contribution(const SensorModel& model, const TaxelSampleReading& r, bool picked) {
  switch (model.layout.readout.aggregate) {
    case Aggregate::weighted_mean:
    case Aggregate::weighted_sum:
    case Aggregate::force:
      return r.weight * r.pressure;
    case Aggregate::mean:
      return model.sample_share(r.sample) * r.pressure;
    case Aggregate::nearest:
    case Aggregate::max:
      return picked ? r.pressure : 0.0;
  }
  return 0.0;
}

}  // namespace

std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  const bool by_distance = model.layout.readout.aggregate == Aggregate::nearest;

  std::vector<TaxelSampleReading> rows;
  double best = -std::numeric_limits<double>::infinity();
  std::size_t picked = 0;
  for (int e = model.fields.first[at(taxel)]; e < model.fields.first[at(taxel) + 1]; ++e) {
    const ReceptiveFields::Entry& entry = model.fields.entries[at(e)];
    const RayHit& hit = hits[at(model.ray_of_entry[at(e)])];
    rows.push_back({entry.sample, hit.hit(), hit.depth, hit.pressure, entry.weight, 0.0});
    const double rank = by_distance ? -entry.distance : hit.pressure;
    if ((hit.hit() || !omit_misses) && rank > best) best = rank, picked = rows.size() - 1;
  }

  double total = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) total += rows[i].share = contribution(model, rows[i], i == picked);
  if (total > 0.0)
    for (TaxelSampleReading& r : rows) r.share /= total;
  return rows;
}

}  // namespace taxel
