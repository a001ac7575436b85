// The polygons of a sensor's contact surfaces with their shares of one taxel's reading.
#pragma once

#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Returns the polygons of all surfaces, in their order. `behind` are the taxel's samples in that step, `exact` is the
/// taxel's exact reading.
std::vector<PolygonBehind> polygons_behind(const SensorModel& model, int taxel, const SensorStep& step,
                                           const std::vector<TaxelSampleReading>& behind, const ExactReading& exact,
                                           const InvertedTets& inverted);

}  // namespace taxel
