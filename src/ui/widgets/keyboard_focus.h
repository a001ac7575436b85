// Decides whether a key press belongs to a widget or to the table of key bindings.
#pragma once

#include <vector>

#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Records at the end of a frame which widget has the keyboard, because ImGui closes popups and leaves fields before
/// the next frame can inspect them. `selection` has the ids of the selected taxels; a change of the selection clears a
/// refused input.
void record_keyboard(Ui& ui, const std::vector<int>& selection);

/// Returns true if keyboard navigation in a panel uses this key. The key then has no effect in the table of bindings.
bool widgets_take(const Ui& ui, int chord);

/// Starts keyboard navigation in a panel, at its first widget. Esc ends it.
void enter_panel(Ui& ui, const char* title);
/// Completes enter_panel(). Called by begin_panel().
void focus_if_entered(Ui& ui, const char* title);

}  // namespace taxel::ui
