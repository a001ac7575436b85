// Unsaved documents and recordings that are kept for the next start.
#pragma once

#include "app/studio/frame/command.h"

namespace taxel::ui {

struct AnswerRecovery {
  bool recover = false;  ///< otherwise the lost document is deleted
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::AnswerRecovery& command, Host& host);

/// Begins to keep unsaved edits, and offers documents and recordings that an earlier program has left.
void start_autosave(Host& host);
/// Writes unsaved edits that are due.
void keep_unsaved(Host& host);
/// Writes unsaved edits for the next start when a signal ends the program.
void keep_unsaved_at_end(Host& host);

}  // namespace taxel::studio
