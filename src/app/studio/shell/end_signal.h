// Signals that ask the program to end: SIGTERM, SIGINT, SIGHUP.
#pragma once

namespace taxel::studio {

/// From now on the first such signal is only recorded, so that the program can end in order; a second signal of the
/// same kind ends the program at once.
void record_end_signals();

/// The number of the first recorded signal, or 0.
[[nodiscard]] int end_signal();

}  // namespace taxel::studio
