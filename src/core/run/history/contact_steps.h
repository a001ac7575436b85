// The part of the recorded steps in which something is touched.
#pragma once

#include <cstddef>
#include <optional>

#include "core/run/history/lanes.h"

namespace taxel {

/// Returns the steps of `within` from the first to the last one in which a sensor touches something, with the steps of
/// at most `margin` seconds before and after them. Empty if no sensor touches anything. Cost: O(rows x sensors).
inline std::optional<StepRange> contact_steps(const HistoryLanes& lanes, const StepRange& within, double margin) {
  std::optional<std::size_t> first, last;
  for (std::size_t row = 0; row < lanes.rows(); ++row) {
    if (lanes.steps[row].step < within.first || lanes.steps[row].step > within.last) continue;
    for (std::size_t sensor = 0; sensor < lanes.sensor_count; ++sensor) {
      if (lanes.sensor(row, sensor).polygons == 0) continue;
      first = first.value_or(row);
      last = row;
      break;
    }
  }
  if (!first) return std::nullopt;
  const double begin = lanes.steps[*first].time - margin, end = lanes.steps[*last].time + margin;
  while (*first > 0 && lanes.steps[*first - 1].step >= within.first && lanes.steps[*first - 1].time >= begin) --*first;
  while (*last + 1 < lanes.rows() && lanes.steps[*last + 1].step <= within.last && lanes.steps[*last + 1].time <= end)
    ++*last;
  return StepRange{lanes.steps[*first].step, lanes.steps[*last].step};
}

}  // namespace taxel
