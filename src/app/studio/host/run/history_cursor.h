// The position in the recorded steps that the user requested.
#pragma once

#include <algorithm>
#include <optional>

#include "core/run/event.h"
#include "core/run/history/replay.h"

namespace taxel::studio {

struct HistoryCursor {
  Replay replay;
  std::optional<StepRange> loop;  ///< steps that a replay repeats; a replay without a loop stops at the end
  std::uint64_t requested = 0;    ///< step that `command` displays
  CommandId command = 0;          ///< the latest command that displays a recorded step

  /// Returns the displayed step, or the requested one if its command is not executed yet.
  [[nodiscard]] std::uint64_t step(CommandId executed, const SimFrame& frame) const {
    return executed < command ? requested : frame.step;
  }
  /// Returns the part of the loop that is recorded, or all recorded steps without a loop.
  [[nodiscard]] StepRange range_in(const HistoryState& history) const {
    StepRange range{history.first, history.last};
    if (!loop) return range;
    return {std::clamp(loop->first, range.first, range.last), std::clamp(loop->last, range.first, range.last)};
  }
};

}  // namespace taxel::studio
