#include "app/studio/app/reading_range.h"

#include <algorithm>

#include "app/studio/app/app.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

void update_range(App& app, double largest_of_run) {
  PressureRange& range = app.viewer.range;
  if (!range.automatic) return;
  double largest = largest_of_run;
  if (const PressedProbePtr& pressed = app.shown.document.probe) {
    app.layout.probe.largest = std::max(app.layout.probe.largest, pressed->largest);
    if (app.viewer.mode == Mode::layout) largest = app.layout.probe.largest;
  }
  range.lo = 0;
  range.hi = std::max(kLeastRange, nice_ceiling(largest));
}

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
