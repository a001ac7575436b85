#include "core/sensor/reading.h"

#include <limits>

#include "core/base/error.h"

namespace taxel {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Calls body(pressure, share of the ray, use) for every entry of every ray that was hit.
template <class Body>
void for_each_use(const ReadoutTable& table, const RayHits& hits, const Body& body) {
  for (const std::int32_t ray : hits.hit_rays()) {
    const double pressure = hits[ray].pressure, share = table.share[index(ray)];
    for (std::int32_t u = table.first[index(ray)]; u < table.first[index(ray) + 1]; ++u)
      body(pressure, share, table.uses[index(u)]);
  }
}

void divide(double* sums, const double* weights, std::size_t taxels) {
  for (std::size_t k = 0; k < taxels; ++k) sums[k] = weights[k] > 0.0 ? sums[k] / weights[k] : 0.0;
}

}  // namespace

void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings) {
  const ReadoutTable& table = model.readout_table;
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  const std::size_t taxels = index(model.taxel_count());
  readings.assign(2 * taxels, 0.0);
  double* sum = readings.data();
  double* of_hits = sum + taxels;  // weights, or the distance of the nearest one
  switch (how) {
    case Aggregate::weighted_mean:
    case Aggregate::weighted_sum:
      for_each_use(table, hits, [&](double pressure, double, const ReadoutTable::Use& use) {
        sum[index(use.taxel)] += use.weight * pressure;
        of_hits[index(use.taxel)] += use.weight;
      });
      if (how == Aggregate::weighted_mean) divide(sum, omit_misses ? of_hits : table.weight_sum.data(), taxels);
      break;
    case Aggregate::mean:
      for_each_use(table, hits, [&](double pressure, double share, const ReadoutTable::Use& use) {
        sum[index(use.taxel)] += share * pressure;
        of_hits[index(use.taxel)] += share;
      });
      divide(sum, omit_misses ? of_hits : table.share_sum.data(), taxels);
      break;
    case Aggregate::nearest:
      if (!omit_misses) {
        for (std::size_t k = 0; k < taxels; ++k) sum[k] = table.nearest[k] < 0 ? 0.0 : hits[table.nearest[k]].pressure;
        break;
      }
      std::fill_n(of_hits, taxels, std::numeric_limits<double>::infinity());
      for_each_use(table, hits, [&](double pressure, double, const ReadoutTable::Use& use) {
        const std::size_t k = index(use.taxel);
        if (use.distance < of_hits[k]) of_hits[k] = use.distance, sum[k] = pressure;
      });
      break;
    case Aggregate::max:
      for_each_use(table, hits, [&](double pressure, double, const ReadoutTable::Use& use) {
        sum[index(use.taxel)] = std::max(sum[index(use.taxel)], pressure);
      });
      break;
    case Aggregate::force:
      throw Error("", "/readout/aggregate", "\"force\" is not available yet");
  }
  readings.resize(taxels);
}

void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path) {
  cast_rays(model, surfaces, path, out.workspace, out.hits);
  aggregate(model, out.hits, model.layout.readout.aggregate, out.values);
}

}  // namespace taxel
