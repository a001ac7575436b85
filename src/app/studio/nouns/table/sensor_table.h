// The table of the taxels of several sensors, with their readings.
#pragma once

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/table/table_state.h"

namespace taxel::ui {

/// Draws the table into the rest of the panel: sensor, id, name, samples and reading of each taxel.
void draw_sensor_table(WindowUi& ui, Selection& selection, TableState& state, const std::vector<SensorShown>& sensors);

}  // namespace taxel::ui
