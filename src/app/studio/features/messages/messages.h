// Messages: floating toasts that can be copied and closed, and the list of all.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
void draw_toasts(UiState& ui);
void draw_messages_panel(UiState& ui);
/// Whether a note is still to leave the view, so that another picture will be needed.
[[nodiscard]] bool toasts_will_change(const UiState& ui);
}  // namespace taxel::ui
