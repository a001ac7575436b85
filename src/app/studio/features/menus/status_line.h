// The line at the bottom: rates, force, counts, messages.
#pragma once

#include <string>

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_status_line(UiState& ui, const UiInput& input);

/// "0.98 x real time", or that the simulation is "paused" or has "ended"; empty where there is none, or no clock.
std::string pace_text(const UiInput& input);
}  // namespace taxel::ui
