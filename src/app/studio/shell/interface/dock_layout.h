// Arrangement of the panels in the window: the view, a column of panels at its right, and a row below it.
#pragma once

#include <array>
#include <span>
#include <string>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_state.h"

namespace taxel::ui {

/// Switches to the arrangement of the mode, and enlarges or restores a panel, as Arrangement says. Is called
/// between two frames.
void switch_arrangement(App& app);
/// Returns the text of each mode's arrangement. A text is empty if its mode was never displayed.
[[nodiscard]] std::array<std::string, 3> arrangement_texts(const App& app);

/// Covers the part of the window that menus, toolbar, timeline and status line leave free. Arranges the panels at
/// first, and when Arrangement::reset is set.
void draw_dock_space(App& app);

/// Returns whether tabs are narrow, and those of the column of panels have no button to close them, so that all their
/// titles are readable: in ANALYSE, and in a compact window.
[[nodiscard]] bool has_narrow_tabs(const App& app);

/// Returns whether a panel is to be drawn while another one may fill the window.
[[nodiscard]] bool has_room(const Arrangement& arrangement, const char* title, Dock dock);

}  // namespace taxel::ui
