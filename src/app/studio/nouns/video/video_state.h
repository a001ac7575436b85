// A video of the recorded steps: its settings and its progress.
#pragma once

#include <cstddef>

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

}  // namespace taxel::ui
