// The curves of an episode: readings and force over time, or over travel for a sweep.
#pragma once

#include <imgui.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {

/// Draws both plots of the chosen episode side by side, or one below the other in a narrow area. Draws nothing until
/// the rows are read.
void draw_episode_plots(WindowUi& ui, const DocumentView& document, DataSetState& state, ImVec2 size);

}  // namespace taxel::ui
