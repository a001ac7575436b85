// The panel that compares a run with a second layout: numbers, bars and curves of both, on one contact and one
// timeline.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/compare/compare_state.h"

namespace taxel::ui {

void draw_compare_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, CompareState& compare, bool& open);

}  // namespace taxel::ui
