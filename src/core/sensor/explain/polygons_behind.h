// The polygons of a sensor's contact surfaces as one taxel sees them.
#pragma once

#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Of all surfaces, in their order. `behind`: the taxel's samples in that step; `exact`: its exact reading.
std::vector<PolygonBehind> polygons_behind(const SensorModel& model, int taxel, const SensorStep& step,
                                           const std::vector<TaxelSampleReading>& behind, const ExactReading& exact,
                                           const InvertedTets& inverted);

}  // namespace taxel
