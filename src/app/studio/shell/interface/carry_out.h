// Carries out the rows of the keymap, for keys, menus and buttons alike.
#pragma once

#include "app/studio/frame/keymap.h"

namespace taxel::ui {

[[nodiscard]] bool is_enabled(const Binding& row, const App& app);
[[nodiscard]] bool is_checked(const Binding& row, const App& app);
/// Returns the reason why a row is disabled; empty if the row is enabled or gives no reason.
[[nodiscard]] std::string why_disabled(const Binding& row, const App& app);

/// Carries out the command of a row if the row is enabled: at once if the command is about the interface alone,
/// otherwise after the frame.
void carry_out_if_enabled(const Binding& row, App& app);
/// Does the same for a command that has a row.
void carry_out_if_enabled(const Command& command, App& app);

/// Carries out the rows whose keys are pressed in this frame. A focused text field, an open dialog or menu comes first.
void handle_keys(App& app);

}  // namespace taxel::ui
