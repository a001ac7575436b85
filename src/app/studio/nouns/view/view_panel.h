// The 3-D view: draws the scene when something changed, and the text that floats over it.
#pragma once

#include <imgui.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/profiler/profile_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "ui/scene/scene_renderer.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

/// Draws the scene into the renderer's texture if something visible has changed.
void render_if_changed(Viewer& viewer, ProfileState& profile, ViewShown& view, SceneInput scene,
                       SceneRenderer& renderer, int width, int height);
/// Returns whether the view shows pressures of a contact.
bool shows_pressure(const Viewer& viewer, const Shown& shown);
/// Returns the place of the legend of colours, in the upper right corner.
LegendPlace legend_place(const ViewPlace& place, const LegendScales& scales);
/// Draws mode and name in the upper left corner.
/// The text ends where the legend begins, which is `legend_width` wide.
void draw_heading(const WindowUi& ui, const Viewer& viewer, const Shown& shown, float legend_width, ImDrawList& list);
void draw_border(const WindowUi& ui, const Viewer& viewer, ImDrawList& list);
/// Draws a tooltip about the object under the resting pointer.
void draw_hover_tooltip(const Viewer& viewer, const Shown& shown);
void draw_labels(const WindowUi& ui, const ViewPlace& place, const ViewShown& view, ImDrawList& list);

}  // namespace taxel::ui
