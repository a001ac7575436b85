#include "app/studio/app/reading_range.h"

#include <algorithm>

#include "ui/widgets/format.h"

namespace taxel::ui {

PressureRange reading_range(const UiState& ui, const UiInput& input) {
  const SensorStep* state = input.shown_state(ui);
  const SensorModelPtr model = input.shown_model(ui);
  if (state == nullptr || !model) return ui.range;
  const ReadingUnit unit = shown_unit(model->layout.readout.aggregate);
  if (unit.pressure) return ui.range;
  double largest = 0;
  for (const double reading : state->readings) largest = std::max(largest, reading);
  if (ui.mode == Mode::simulate)
    for (const double peak : input.peaks) largest = std::max(largest, peak);
  return {0, axis_top(largest, unit), true, ui.range.colors};
}

}  // namespace taxel::ui
