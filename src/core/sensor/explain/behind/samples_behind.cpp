#include "core/sensor/explain/behind/samples_behind.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {
std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  const AggregateSpec& spec = aggregate_spec(model.layout.readout.aggregate);

  std::vector<TaxelSampleReading> rows;
  double best = -std::numeric_limits<double>::infinity();
  std::optional<std::size_t> picked;
  for (int e = model.fields.first[at(taxel)]; e < model.fields.first[at(taxel) + 1]; ++e) {
    const ReceptiveFields::Entry& entry = model.fields.entries[at(e)];
    const RayHit& hit = hits[at(model.readout_table.ray_of_entry[at(e)])];
    const SampleUse use{entry.weight, model.sample_share(entry.sample), entry.distance, hit.pressure};
    rows.push_back({entry.sample, hit.hit(), hit.depth, hit.pressure, entry.weight, 0.0});
    if (spec.contribution != nullptr) {
      rows.back().share = spec.contribution(use);
    } else if (const double rank = spec.rank(use); (hit.hit() || !omit_misses) && rank > best) {
      best = rank, picked = rows.size() - 1;
    }
  }
  if (picked) rows[*picked].share = rows[*picked].pressure;

  double total = 0.0;
  for (const TaxelSampleReading& r : rows) total += r.share;
  if (total > 0.0)
    for (TaxelSampleReading& r : rows) r.share /= total;
  return rows;
}

}  // namespace taxel
