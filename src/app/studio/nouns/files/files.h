// Floating windows: the help, the progress of a load, and popups for unsaved work and recovery.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::ui {

/// Draws a card about a load or a scene that is being built.
void draw_loading(WindowUi& ui, const ViewPlace& place, const DocumentView& document);
/// Notices, dialogs and questions about files.
extern const Feature kFiles;
/// Sets "recovery" and "notices".
void dump_files(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
