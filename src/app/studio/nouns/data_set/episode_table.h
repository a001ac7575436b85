// The table of episodes and failed jobs.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {

/// Draws the filter and the table into the rest of the window. A click chooses an episode, a double click opens it.
void draw_episode_table(WindowUi& ui, DataSetState& state);

}  // namespace taxel::ui
