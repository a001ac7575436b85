// Messages for the user, in order of arrival.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace taxel::ui {

/// How long a message is true. When it is not true any more, it leaves the line.
enum class Holds {
  always,                ///< it reports an event
  for_document,          ///< until another document is open
  until_edit,            ///< until an edit succeeds, or another document is open
  for_run,               ///< until another run begins or an edit succeeds; then it is removed
  while_paused,          ///< until the displayed step moves again, or another document is open
  while_unrunnable,      ///< until the layout can be simulated
  while_unkept,          ///< until unsaved edits are kept
  while_mesh_missing,    ///< until the layout that waits for its mesh has it
  while_dialog_is_open,  ///< until the desktop's file dialog is closed
  while_export_waits     ///< until the export that waits for polished samples is written
};

/// A line for the user. It is displayed until it is closed or is not true any more. Notes that are always true are
/// displayed for a while.
struct Message {
  Severity severity = Severity::note;
  std::string text;
  int number = 0;       ///< 1, 2, ... in order of arrival
  double shown_at = 0;  ///< interface time [s]
  Holds holds = Holds::always;
  bool toast = true;  ///< whether the line above the status line displays it, now or after newer ones
};

using Messages = std::vector<Message>;

/// Adds a message for the user; `now` is the interface time [s]. Without `is_shown` the message is only listed. A
/// message that repeats the newest one takes its place.
void add_message(Messages& messages, Severity severity, std::string text, double now, Holds holds = Holds::always,
                 bool is_shown = true);

/// Takes the messages that are not true any more from the line. They stay in the list, except findings about a run:
/// they would be read as if they were about the next one.
void end_messages(Messages& messages, Holds holds);

}  // namespace taxel::ui
