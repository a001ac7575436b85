// Floating windows: the help, the progress of a load, and popups for unsaved work and recovery.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/files_state.h"

namespace taxel::ui {
void draw_loading(WindowUi& ui, const ViewPlace& place, const DocumentView& document);
/// Draws the question whether to save, before unsaved edits are discarded.
void draw_unsaved_question(WindowUi& ui, const DocumentView& document, bool& asks_unsaved);
/// Draws the offer to recover the document that an abnormally ended program had saved.
void draw_recovery_card(WindowUi& ui, Recovery& recovery);
}  // namespace taxel::ui
