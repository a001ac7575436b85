// Carries out the rows of the keymap, for keys, menus and buttons alike.
#pragma once

#include "app/studio/app/keymap.h"
#include "app/studio/app/ui_state.h"

namespace taxel::ui {

[[nodiscard]] bool is_enabled(const Binding& row, const UiState& ui, const UiInput& input);
[[nodiscard]] bool is_checked(const Binding& row, const UiState& ui, const UiInput& input);

/// Carries out the command of a row if the row is enabled: at once if the command is about the interface alone,
/// otherwise after the frame.
void perform(const Binding& row, UiState& ui, const UiInput& input);
/// Does the same for a command that has a row.
template <class C>
void perform(const C& command, UiState& ui, const UiInput& input) {
  perform(binding_of(command), ui, input);
}

/// Carries out the rows whose keys are pressed in this frame. A focused text field, an open dialog or menu comes first.
void handle_keys(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
