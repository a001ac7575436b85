// Actions on what the 3-D view shows, and from where.
#pragma once

#include <optional>

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

/// Returns whether the action was one of these.
bool perform_on_view(Action action, UiState& ui, const UiInput& input);
/// None: it is not one of these.
[[nodiscard]] std::optional<bool> is_view_enabled(Action action, const UiState& ui, const UiInput& input);
/// The overlay that an action turns on and off, or null.
[[nodiscard]] bool* overlay_switch(Action action, Overlays& overlays);

}  // namespace taxel::ui
