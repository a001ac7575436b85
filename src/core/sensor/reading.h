// From hits to numbers: one value per taxel.
#pragma once

#include <vector>

#include "core/sensor/cast_rays.h"

namespace taxel {

/// One value per taxel in layout order; pascals, newtons for Aggregate::force. A taxel without samples reads 0.
/// weighted_mean: sum w p / sum w (the paper); weighted_sum: sum w p (its released code); mean; nearest; max.
void aggregate(const SensorModel& model, const std::vector<RayHit>& hits, Aggregate how, std::vector<double>& readings);

/// Everything one evaluation needs and produces, reused from step to step.
struct SensorReading {
  SurfaceCaster caster;
  std::vector<RayHit> hits;    ///< parallel to model.rays
  std::vector<double> values;  ///< layout.readout.aggregate
};
void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out);

}  // namespace taxel
