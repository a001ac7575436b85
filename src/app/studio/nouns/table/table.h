// The table of all taxels of the displayed layout, with their readings.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// A row for each taxel.
extern const Feature kTaxelTable;
/// Sets "table": the rows in displayed order, and whether a cell is being edited.
void dump_table(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
