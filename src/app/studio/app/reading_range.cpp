#include "app/studio/app/reading_range.h"

#include <algorithm>

#include "ui/widgets/format.h"

namespace taxel::ui {

PressureRange reading_range(const Viewer& viewer, const Shown& shown) {
  const SensorStep* state = shown.state(viewer);
  const SensorModelPtr model = shown.model(viewer);
  if (state == nullptr || !model) return viewer.range;
  const ReadingUnit unit = shown_unit(model->layout.readout.aggregate);
  if (unit.pressure) return viewer.range;
  double largest = 0;
  for (const double reading : state->readings) largest = std::max(largest, reading);
  if (viewer.mode == Mode::simulate)
    for (const double peak : shown.run.peaks) largest = std::max(largest, peak);
  return {0, axis_top(largest, unit), true, viewer.range.colors};
}

}  // namespace taxel::ui
