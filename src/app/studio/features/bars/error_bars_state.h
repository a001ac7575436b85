// The switch of the error bars.
#pragma once

namespace taxel::ui {

struct ErrorBarsState {
  bool on = false;  ///< whether error bars are measured and drawn
};

}  // namespace taxel::ui
