// Whether a key belongs to a widget or to the table of bindings.
#pragma once

#include <vector>

#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Records at the end of a frame which widget has the keyboard, because ImGui closes a popup and leaves a field before
/// the next frame asks. `selection`: ids of the selected taxels; another selection clears what a field had refused.
void record_keyboard(Ui& ui, const std::vector<int>& selection);

/// Whether the key is not for the table of bindings because the keyboard walks through a panel, and the key is one of
/// those that do.
bool widgets_take(const Ui& ui, int chord);

/// The keyboard walks through the panel from its first widget on; Esc ends that.
void enter_panel(Ui& ui, const char* title);
/// For begin_panel: carries out enter_panel.
void focus_if_entered(Ui& ui, const char* title);

}  // namespace taxel::ui
