// The card in the view while nothing is open: an invitation, pictures of the examples, and recent files.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::ui {

/// Draws the card in the middle of the view. A click on a picture opens its example.
void draw_start_card(WindowUi& ui, const ViewPlace& place, const std::vector<ExampleTile>& examples, FileDialog& dialog,
                     const std::vector<std::string>& recent);

}  // namespace taxel::ui
