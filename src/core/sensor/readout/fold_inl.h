// Loops over the rays that were hit, shared by the aggregates.
#pragma once

#include <algorithm>
#include <limits>

#include "core/base/math.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/reference/field_integral.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Calls body(ray, value, share of the ray, use) for each use of each ray that was hit, rays ascending: the sums have
/// the same bits for the same hits.
template <class ValueOf, class Body>
void for_each_use(const ReadoutTable& table, const ValueOf& value_of, const Body& body) {
  for (const std::int32_t ray : value_of.hits.hit_rays()) {
    const auto value = value_of(ray);
    const double share = table.share[at(ray)];
    for (std::int32_t u = table.first[at(ray)]; u < table.first[at(ray) + 1]; ++u)
      body(ray, value, share, table.uses[at(u)]);
  }
}

/// Adds up weight x value per taxel, and the weights.
template <class V, class ValueOf>
void add_weighted(const ReadoutTable& table, const ValueOf& value_of, V* sums, double* weights) {
  for_each_use(table, value_of, [&](auto, const V& value, double, const ReadoutTable::Use& use) {
    sums[at(use.taxel)] += use.weight * value;
    weights[at(use.taxel)] += use.weight;
  });
}

/// Divides the sums of the hits by the weights of the hits if misses are omitted, otherwise by the weights `of_all`
/// samples. A taxel without weight reads 0.
template <class V>
void divide(const SensorModel& model, V* sums, const double* of_hits, const std::vector<double>& of_all) {
  const double* weights = model.layout.readout.misses == Misses::omit ? of_hits : of_all.data();
  const std::size_t taxels = at(model.taxel_count());
  for (std::size_t k = 0; k < taxels; ++k) sums[k] = weights[k] > 0.0 ? sums[k] / weights[k] : V(0);
}

}  // namespace taxel
