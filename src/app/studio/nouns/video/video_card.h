// The settings of a video and the popup with its progress.
#pragma once

#include <string>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/video/video_state.h"

namespace taxel::ui {

/// Draws the rows of the file dialog for a video. The choice of the format changes the extension of `path`.
void draw_video_settings(WindowUi& ui, VideoState& video, std::string& path);
inline constexpr float kVideoSettingRows = 4;  ///< number of these rows

/// The progress of a video.
extern const Feature kVideo;
/// Sets "video": its progress and its choices.
void dump_video(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
