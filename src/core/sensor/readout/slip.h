// Incipient slip: the share of each taxel's field that slips.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/friction/sticking_friction.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Computes, per taxel, the share of its touched field that slips, from 0 (all sticks, or no contact) to 1: the sum of
/// w A over the slipping roots divided by that over all roots, with the weight w of the receptive field at the root and
/// the area A of contact that the root bears. The frictions are in frame M; null ones have no contact.
void read_slip(const SensorModel& model, const FieldWeights& weights,
               std::span<const StickingFriction* const> frictions, std::vector<double>& slip);

}  // namespace taxel
