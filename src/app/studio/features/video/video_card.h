// The settings of a video and the popup with its progress.
#pragma once

#include <string>

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/video/video_state.h"

namespace taxel::ui {

/// Draws the rows of the file dialog for a video. The choice of the format changes the extension of `path`.
void draw_video_settings(WindowUi& ui, VideoState& video, std::string& path);
inline constexpr float kVideoSettingRows = 4;  ///< number of these rows
void draw_video_card(WindowUi& ui, const ViewPlace& place, const VideoState& video_state);

}  // namespace taxel::ui
