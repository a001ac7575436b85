// The time that each frame of the window takes, split into its parts.
#pragma once

#include <deque>

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// Time of the main thread for one frame [s].
struct PictureCost {
  double panels = 0;  ///< time of the panels and of the requests that they post
  /// Time of the 3-D view, if the view is redrawn. A software renderer continues to draw the view meanwhile.
  double scene = 0;
  double window = 0;  ///< time to fill the window
};

struct ProfileState {
  static constexpr std::size_t kPictures = 240;
  std::deque<PictureCost> pictures;  ///< latest frames, oldest first
  double scene_seconds = 0;          ///< time of the 3-D view in the present frame [s]
};

/// The panel with the time of simulation steps and of frames, split into parts.
extern const Feature kProfiler;
/// Sets "profile": the means of the costs [s].
void dump_profile(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
