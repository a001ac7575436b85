#include "core/run/history/trace_row.h"

#include <algorithm>

namespace taxel {

TraceRow trace_row_of(const StepView& step, SampleQuality quality) {
  const auto any = [&](const auto& has) { return std::ranges::any_of(step.sensors, has); };
  const bool has_shear = any([](const SensorView& sensor) { return !sensor.shear.empty(); });
  const bool has_slip = any([](const SensorView& sensor) { return !sensor.slip.empty(); });
  TraceRow row{step.time, step.travel, {}, quality};
  for (const SensorView& sensor : step.sensors) {
    row.readings.insert(row.readings.end(), sensor.readings.begin(), sensor.readings.end());
    if (has_shear) {
      for (const dvec2& shear : sensor.shear) row.shear.push_back(glm::length(shear));
      row.shear.resize(row.readings.size());
    }
    if (has_slip) {
      row.slip.insert(row.slip.end(), sensor.slip.begin(), sensor.slip.end());
      row.slip.resize(row.readings.size());
    }
  }
  return row;
}

}  // namespace taxel
