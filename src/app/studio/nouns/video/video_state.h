// A video of the recorded steps: its settings and its progress.
#pragma once

#include <cstddef>
#include <string>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

struct VideoProgress {
  bool active = false, checking = false, encoding = false;
  std::size_t done = 0, total = 0;  ///< number of frames
};

enum class VideoFormat { mp4, gif, png };
enum class VideoSize { view, hd, full_hd, custom };

/// The run and the view of which a video would be made now.
struct VideoSource {
  std::size_t steps = 0;      ///< number of recorded steps
  int width = 0, height = 0;  ///< size of the 3-D view [pixels]
};

struct VideoState {
  int every = 20;       ///< number of steps from one frame to the next
  int rate = 50;        ///< frames per second of the video
  bool window = false;  ///< record the whole window instead of the 3-D view
  VideoSize size = VideoSize::view;
  int width = 1280, height = 720;  ///< size of VideoSize::custom [pixels]
  bool annotated = false;          ///< draw time and legend into the video
  bool orbit = false;              ///< turn the camera once around the contact
  VideoSource source;
  VideoProgress progress;
};

/// Draws the rows of the file dialog for a video. The choice of the format changes the extension of `path`.
void draw_video_settings(WindowUi& ui, VideoState& video, std::string& path);
inline constexpr float kVideoSettingRows = 4;  ///< number of these rows

/// The progress of a video.
extern const Feature kVideo;
/// Sets "video": its progress and its choices.
void dump_video(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
