// From hits to numbers: one value per taxel.
#pragma once

#include <vector>

#include "core/sensor/cast_rays.h"

namespace taxel {

/// One value per taxel in layout order; pascals, newtons for Aggregate::force. A taxel without samples reads 0.
/// weighted_mean: sum w p / sum w (the paper); weighted_sum: sum w p (its released code); mean; nearest; max.
/// Sums run over the rays that were hit, in ascending order: the same bits whatever was read before.
void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings);

/// Everything one evaluation needs and produces, reused from step to step.
struct SensorReading {
  CastWorkspace workspace;
  RayHits hits;                ///< of model.rays
  std::vector<double> values;  ///< layout.readout.aggregate
};
/// As cast_rays(), then aggregate().
void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path = RayPath::fastest);

}  // namespace taxel
