// Arrangement of the panels in the window: left outliner and taxels, centre the view, right the inspector, below the
// bars and plots.
#pragma once

#include <span>

#include "app/studio/app/panel_spec.h"

namespace taxel::ui {

/// Covers the part of the window that menus, toolbar and status line leave free. Arranges the panels at first, and when
/// app.window.arrangement.reset is set.
void draw_dock_space(App& app, std::span<const PanelSpec> panels);

}  // namespace taxel::ui
