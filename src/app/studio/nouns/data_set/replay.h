// The replay of an episode in the window: the comparison with the episode, and the sentence about it.
#pragma once

#include <string>

#include "app/studio/frame/shown.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {

/// Continues the comparison of the run with the episode that the document repeats. A run of an edited document is not
/// compared.
void follow_replay(const Shown& shown, DataSetState& state);

/// The outcome of a replay, as far as it is known.
enum class ReplayVerdict {
  none,      ///< no episode is repeated, or its run has no rows yet
  edited,    ///< the document was edited, so that its run is not the episode's
  running,   ///< all rows so far are equal
  equal,     ///< all rows of the episode are equal
  different  ///< rows differ, or their number does
};
[[nodiscard]] ReplayVerdict replay_verdict(const Shown& shown, const DataSetState& state);

/// Returns a sentence about the replay; empty for ReplayVerdict::none. It has the largest difference with its unit,
/// taxel and time.
[[nodiscard]] std::string replay_text(const Shown& shown, const DataSetState& state);

}  // namespace taxel::ui
