// The message about a breakpoint that stopped the simulation.
#pragma once

#include <string>

#include "core/run/event.h"

namespace taxel::studio {

/// Returns a sentence with the step, the taxel and the compared values. `of_sensor` as in Breakpoints.
[[nodiscard]] std::string stop_text(const Stopped& stopped, bool of_sensor);

}  // namespace taxel::studio
