#include "core/sensor/readout/readout_table.h"

#include <limits>

#include "core/sensor/sensor_model.h"

namespace taxel {

ReadoutTable make_readout_table(const SensorModel& model) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const std::size_t rays = model.rays.size(), taxels = index(model.taxel_count());
  ReadoutTable table;
  table.share.reserve(rays);
  for (const SensorRay& ray : model.rays) table.share.push_back(model.sample_share(ray.sample));

  table.first.assign(rays + 1, 0);
  for (const int ray : model.ray_of_entry) ++table.first[index(ray) + 1];
  for (std::size_t r = 0; r < rays; ++r) table.first[r + 1] += table.first[r];
  table.uses.resize(model.ray_of_entry.size());
  std::vector<std::int32_t> filling(table.first.begin(), table.first.end() - 1);
  table.weight_sum.assign(taxels, 0.0);
  table.share_sum.assign(taxels, 0.0);
  table.nearest.assign(taxels, -1);
  for (std::size_t k = 0; k < taxels; ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = model.fields.entries[index(e)];
      const int ray = model.ray_of_entry[index(e)];
      table.uses[index(filling[index(ray)]++)] = {static_cast<std::int32_t>(k), entry.weight, entry.distance};
      table.weight_sum[k] += entry.weight;
      table.share_sum[k] += table.share[index(ray)];
      if (entry.distance < least) least = entry.distance, table.nearest[k] = ray;
    }
  }
  return table;
}

}  // namespace taxel
