// The settings of a video and the popup with its progress.
#pragma once

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/video/video_state.h"

namespace taxel::ui {

void draw_video_settings(WindowUi& ui, VideoState& video);  ///< draws a row of the file dialog
void draw_video_card(WindowUi& ui, const ViewPlace& place, const VideoState& video_state);

}  // namespace taxel::ui
