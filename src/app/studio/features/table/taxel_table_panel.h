// The table of all taxels of the displayed layout, with their readings.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/table/table_state.h"

namespace taxel::ui {
void draw_taxel_table(WindowUi& ui, Viewer& viewer, const Shown& shown, TableState& table_state,
                      const LayoutProblems& problems, PanelsShown& panels);
}  // namespace taxel::ui
