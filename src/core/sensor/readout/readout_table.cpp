#include "core/sensor/readout/readout_table.h"

#include <limits>

#include "core/base/index.h"

namespace taxel {

ReadoutTable make_readout_table(const ReceptiveFields& fields, std::vector<int> ray_of_entry,
                                std::vector<double> share) {
  const std::size_t rays = share.size(), taxels = fields.first.size() - 1;
  ReadoutTable table;
  table.ray_of_entry = std::move(ray_of_entry);
  table.share = std::move(share);
  table.first.assign(rays + 1, 0);
  for (const int ray : table.ray_of_entry) ++table.first[at(ray) + 1];
  for (std::size_t r = 0; r < rays; ++r) table.first[r + 1] += table.first[r];
  table.uses.resize(table.ray_of_entry.size());
  std::vector<std::int32_t> filling(table.first.begin(), table.first.end() - 1);
  table.weight_sum.assign(taxels, 0.0);
  table.share_sum.assign(taxels, 0.0);
  table.nearest.assign(taxels, -1);
  for (std::size_t k = 0; k < taxels; ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (int e = fields.first[k]; e < fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = fields.entries[at(e)];
      const int ray = table.ray_of_entry[at(e)];
      table.uses[at(filling[at(ray)]++)] = {static_cast<std::int32_t>(k), entry.weight, entry.distance};
      table.weight_sum[k] += entry.weight;
      table.share_sum[k] += table.share[at(ray)];
      if (entry.distance < least) least = entry.distance, table.nearest[k] = ray;
    }
  }
  return table;
}

}  // namespace taxel
