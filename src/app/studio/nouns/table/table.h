// The table of all taxels of the displayed layout, with their readings.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/inspector/layout_problems.h"
#include "app/studio/nouns/table/table_state.h"

namespace taxel::ui {
/// A row for each taxel.
extern const Feature kTaxelTable;
/// Sets "table": the rows in displayed order, and whether a cell is being edited.
void dump_table(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
