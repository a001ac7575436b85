// All panels of the window, except the 3-D view.
#pragma once

#include <span>

#include "app/studio/app/panel_spec.h"

namespace taxel::ui {

/// One row per panel; panels are drawn, and listed in the menu Panels, in this order.
std::span<const PanelSpec> panels();

/// Returns whether a panel is open and has something to display in the mode. A panel that opens by itself counts as
/// open.
[[nodiscard]] bool is_drawn(const PanelSpec& panel, const App& app);
[[nodiscard]] bool is_open(PanelSwitch panel, const App& app);
bool& messages_switch(App& app);
bool& history_switch(App& app);
/// Of the card of numbers about the scene, and of the keys and mouse: both are no panels of the arrangement.
bool& info_switch(App& app);
bool& help_switch(App& app);

}  // namespace taxel::ui
