// How a video is made, and how far it is.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void draw_video_settings(UiState& ui);  ///< a row of the file dialog
void draw_video_card(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
