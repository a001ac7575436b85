// Carries out the actions of the keymap, whoever asked: a key, a menu or a button.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

void perform(Action action, UiState& ui, const UiInput& input);
[[nodiscard]] bool is_checked(Action action, const UiState& ui);
[[nodiscard]] bool is_enabled(Action action, const UiState& ui, const UiInput& input);

/// Performs what the keys of this frame ask for. A focused text field, an open dialog or menu comes first.
void handle_keys(UiState& ui, const UiInput& input);

/// The speed one notch above or below, along 1/16 ... 1/2, 1, 2 ... 16.
[[nodiscard]] double next_speed(double speed, bool faster);

/// What a click on a taxel does, wherever it is shown: it selects it alone, or with Shift also, or not any more.
void click_taxel(UiState& ui, int id, bool shift);

/// The file dialog, with empty fields; and its folder listed.
void begin_dialog(UiState& ui, FileTask task);
void open_dialog(UiState& ui);

void add_message(UiState& ui, Severity severity, std::string text, double now);

}  // namespace taxel::ui
