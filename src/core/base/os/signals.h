// Signals that ask a program to end: SIGINT, SIGTERM and SIGHUP. A signal that the parent process ignores, as nohup
// does with SIGHUP, stays ignored.
#pragma once

#include <functional>

namespace taxel::os {

/// Starts a thread that calls `receive` with the number of each such signal. Call this before any other thread starts.
void receive_end_signals(std::function<void(int)> receive);

/// Calls `record` with the number of the first signal of each kind, at any place of the program, so that it may only
/// set atomic variables. A second signal of the same kind ends the program at once.
void record_end_signals(void (*record)(int));

/// Returns the name of a signal for messages, such as "SIGTERM".
[[nodiscard]] const char* signal_name(int number);

}  // namespace taxel::os
