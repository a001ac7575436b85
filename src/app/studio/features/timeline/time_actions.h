// Actions that move through recorded steps, and what stops the simulation.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// False where the action is none of these.
bool perform_in_time(Action action, UiState& ui, const UiInput& input);
/// Whether there is anything to move through.
[[nodiscard]] bool has_history(const UiInput& input);

}  // namespace taxel::ui
