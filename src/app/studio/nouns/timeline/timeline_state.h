// The timeline: where its tracks were drawn, and the effect of a drag in them.
#pragma once

#include <cstdint>
#include <optional>

#include "core/run/history/lanes.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

struct Timeline {
  bool unfolded = false;                    ///< whether all tracks are drawn, not just one line; a setting
  Rect lanes;                               ///< all tracks, without their names, or the line of play
  StepRange steps;                          ///< steps at the left and the right edge of the tracks
  int marks = 0;                            ///< number of drawn events
  bool scrubs = false;                      ///< whether a drag moves the cursor
  std::optional<std::uint64_t> loops_from;  ///< step at which the dragged range begins or ends
};

}  // namespace taxel::ui
