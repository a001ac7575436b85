// Texts over the 3-D view about the scene: the followed camera or body, the displayed glyphs, and the information (F2).
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/view/view_state.h"

namespace taxel::ui {
/// Draws the texts. `row` is the first free line below the heading. Returns the next free line.
int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row);
/// Draws the information in a separate window, from line `row` on. Must be called after the view's window is drawn.
void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row);

/// The card with numbers about the scene, which the view draws.
extern const Feature kInfo;
/// Sets the contents of the 3-D view: "labels", "marks", "skin", "info" and others.
void dump_view(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
