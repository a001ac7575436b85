// Whether a key belongs to a widget or to the table of bindings.
#pragma once

#include "ui/ui_state.h"

namespace taxel::ui {

/// At the end of a picture: notes who has the keyboard, because ImGui closes a popup and leaves a field before the next
/// picture asks.
void note_keyboard(UiState& ui);

/// Whether the key is not for the table of bindings because the keyboard walks through a panel, and the key is one of
/// those that do.
bool widgets_take(const UiState& ui, int chord);

/// The keyboard walks through the panel from its first widget on; Esc ends that.
void enter_panel(UiState& ui, const char* title);
/// For begin_panel: carries out enter_panel.
void focus_if_entered(UiState& ui, const char* title);

}  // namespace taxel::ui
