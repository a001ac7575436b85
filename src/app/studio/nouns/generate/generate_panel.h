// The panel that generates many taxels at once: a pattern, its parameters, and a live preview in the view.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/menus/tour_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {
/// Patterns of taxels. The panel opens by its own state.
extern const Feature kGenerate;
/// Draws the frame of the pattern in the view: the centre, the direction of the rows and the direction across them.
void draw_pattern_frame(const Viewer& viewer, const Shown& shown, const GenerateState& generate);
/// Sets "generate", which is null while the panel is closed.
void dump_generate(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
