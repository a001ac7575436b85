// The example of the paper's artifact: the run pauses when a taxel jumps, and the jump is explained at once.
#pragma once

namespace taxel::ui {

struct HuntState {
  using PerDocument = HuntState;  ///< another document resets all of it

  bool waits_for_jump = false;  ///< whether the first stop of the run is to be explained
};

}  // namespace taxel::ui
