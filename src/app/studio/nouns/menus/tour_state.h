// The tour of the interface.
#pragma once

namespace taxel::ui {

struct TourState {
  int step = -1;      ///< displayed step, or -1 if the tour is closed
  bool seen = false;  ///< whether the tour has ended once; stored in the settings file
};

}  // namespace taxel::ui
