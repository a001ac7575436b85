// Where the time of pictures goes.
#pragma once

#include <deque>

namespace taxel::ui {

/// Time of the main thread for one picture [s].
struct PictureCost {
  double panels = 0;  ///< layout, and what is asked of the program
  double scene = 0;   ///< the 3-D view, where it is drawn anew; a software renderer goes on with it meanwhile
  double window = 0;  ///< filling the window
};

struct ProfileState {
  static constexpr std::size_t kPictures = 240;
  std::deque<PictureCost> pictures;  ///< latest ones, oldest first
  double scene_seconds = 0;          ///< of the picture that is made now
};

}  // namespace taxel::ui
