// All panels of the window, except the 3-D view.
#pragma once

#include <span>

#include "app/studio/app/panel_spec.h"

namespace taxel::ui {

/// One row per panel; panels are drawn, and listed in the menu Panels, in this order.
std::span<const PanelSpec> panels();

}  // namespace taxel::ui
