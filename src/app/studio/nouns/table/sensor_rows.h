// The rows of the table of taxels if it lists the taxels of several sensors.
#pragma once

#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/nouns/table/table_state.h"

namespace taxel::ui {

/// Returns the taxels that pass the filter, in the order of the table. A taxel passes if its id, its name or the name
/// of its sensor contains the filter, ignoring case. Rows that are equal in the sorted column keep the order of the
/// sensors and their layouts.
[[nodiscard]] std::vector<SensorRow> sensor_rows(const TableState& table, const std::vector<SensorShown>& sensors);

}  // namespace taxel::ui
