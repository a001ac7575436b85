// A video of the recorded steps: its settings and its progress.
#pragma once

#include <cstddef>

namespace taxel::ui {

struct VideoProgress {
  bool active = false, encoding = false;
  std::size_t done = 0, total = 0;  ///< number of frames
};

struct VideoState {
  int every = 20;       ///< number of steps from one frame to the next
  int rate = 50;        ///< frames per second of the video
  bool window = false;  ///< record the whole window instead of the 3-D view
  VideoProgress progress;
};

}  // namespace taxel::ui
