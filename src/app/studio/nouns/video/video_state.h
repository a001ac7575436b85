// A video of the recorded steps: its settings and its progress.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/run/history/lanes.h"

namespace taxel::ui {

struct VideoProgress {
  bool active = false, checking = false, encoding = false;
  std::size_t done = 0, total = 0;  ///< number of frames
};

enum class VideoFormat { webp, mp4, gif, png };
enum class VideoSize { view, hd, full_hd, custom };
/// The steps of a video: those with contact, all that are recorded or in the loop, or those of a period.
enum class VideoSteps { contact, all, period };

/// The run and the view of which a video would be made now.
struct VideoSource {
  StepRange steps;                   ///< recorded steps, or those of the loop
  std::optional<StepRange> contact;  ///< the part of them with contact; empty if there is none
  std::optional<StepRange> period;   ///< the part from VideoState::from to VideoState::to; empty if that has no step
  double begin = 0, end = 0;         ///< times of the first and the last step [s]
  double timestep = 0;               ///< simulated time of a step [s]; 0 if unknown
  int width = 0, height = 0;         ///< size of the 3-D view [pixels]
  bool has_encoder = false;          ///< whether ffmpeg is installed, which MP4 and GIF need
};

struct VideoState {
  int every = 20;       ///< number of steps from one frame to the next
  int rate = 50;        ///< frames per second of the video
  bool window = false;  ///< record the whole window instead of the 3-D view
  VideoSize size = VideoSize::view;
  int width = 1280, height = 720;  ///< size of VideoSize::custom [pixels]
  VideoSteps steps = VideoSteps::contact;
  double from = 0, to = 0;  ///< times of VideoSteps::period [s]
  bool annotated = true;    ///< draw time, force and legend into the video
  bool bars = true;         ///< draw the readings of the taxels as bars into the video
  bool orbit = false;       ///< turn the camera once around the contact
  VideoSource source;
  VideoProgress progress;
};

/// Draws the rows of the file dialog for a video. The choice of the format changes the extension of `path`. Returns why
/// no video can be made with these settings, with a remedy; empty if it can.
[[nodiscard]] std::string draw_video_settings(WindowUi& ui, VideoState& video, std::string& path);
inline constexpr float kVideoSettingRows = 5;  ///< number of these rows

/// The progress of a video.
extern const Feature kVideo;
/// Sets "video": its progress and its choices.
void dump_video(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
