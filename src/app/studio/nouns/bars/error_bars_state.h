// The switches of the error bars.
#pragma once

#include <string>

namespace taxel::ui {

struct ErrorBarsState {
  bool on = false;      ///< whether error bars are measured and drawn
  bool within = false;  ///< whether samples are added until the bars are within 1 %; needs `on`
  std::string text;     ///< result or next edit of the switch `within`; empty while it is off
};

}  // namespace taxel::ui
