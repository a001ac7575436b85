// The panel of controls: the chosen geoms and the filter of their list.
#pragma once

#include <string>
#include <vector>

namespace taxel::ui {

struct ControlsState {
  using PerDocument = ControlsState;  ///< another document resets all of it
  std::vector<std::string> geoms;     ///< geoms that a layout is to be attached to
  std::string filter;                 ///< part of a geom's name, any case
  bool wants_focus = false;           ///< whether another scene was opened
};

}  // namespace taxel::ui
