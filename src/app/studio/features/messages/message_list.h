// Messages for the user, in order of arrival.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace taxel::ui {

/// A line for the user. Errors and warnings are displayed until closed, notes for a while.
struct Message {
  Severity severity = Severity::note;
  std::string text;
  int number = 0;       ///< 1, 2, ... in order of arrival
  double shown_at = 0;  ///< interface time [s]
  bool toast = true;    ///< whether the line above the status line displays it, now or after newer ones
};

using Messages = std::vector<Message>;

/// Adds a message for the user; `now` is the interface time [s]. Without `is_shown` the message is only listed.
void add_message(Messages& messages, Severity severity, std::string text, double now, bool is_shown = true);

}  // namespace taxel::ui
