// What floats: help, the progress of a load, the card of an empty window.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/files/files_state.h"

namespace taxel::ui {
void draw_help(WindowUi& ui, PanelsShown& panels);
void draw_loading(WindowUi& ui, const ViewPlace& place, const DocumentView& document);
/// Whether to save, before unsaved edits are left.
void draw_unsaved_question(WindowUi& ui, const DocumentView& document, bool& asks_unsaved);
/// Offers what a program that ended badly had kept.
void draw_recovery_card(WindowUi& ui, Recovery& recovery);
/// In the middle of the view while nothing is open.
void draw_start_card(WindowUi& ui, const ViewPlace& place, FileDialog& dialog, const std::vector<std::string>& recent);
}  // namespace taxel::ui
