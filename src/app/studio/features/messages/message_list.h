// Messages for the user, in order of arrival.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace taxel::ui {

/// A line for the user. Errors and warnings are displayed until closed; notes leave the view after a while.
struct Message {
  Severity severity = Severity::note;
  std::string text;
  int number = 0;       ///< 1, 2, ... in order of arrival
  double shown_at = 0;  ///< interface time [s]
  bool toast = true;    ///< whether it floats over the view
};

using Messages = std::vector<Message>;

/// Adds a message for the user; `now` is the interface time [s].
void add_message(Messages& messages, Severity severity, std::string text, double now);

}  // namespace taxel::ui
