// The whole window of one frame: menus, toolbar, status line, docked panels, dialogs.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

struct App;

/// Between ImGui::NewFrame and ImGui::Render. Leaves the posted commands and the places of widgets in `app.ui`.
void draw_interface(App& app, SceneRenderer& renderer);

/// Lets the camera of the demo rest, because the user acts; the demo plays on.
void rest_demo_camera(App& app);
/// Ends the demo of the start, or invites to go on from the demo if its document was just opened.
void follow_opened_document(App& app);
/// The run of the open document is made at once, and its largest step is displayed and explained.
void explain_largest_step(App& app);

/// Draws the window of the 3-D view: the scene, the pointer in it and the text over it.
void draw_view(App& app, SceneRenderer& renderer);

/// Reads the pointer over the view's item and gives it to the tools in the order of the rows, until one consumes it.
void handle_view_mouse(App& app);

/// Resets everything in the window that belongs to the document, because another document was opened.
void forget_document(App& app);

}  // namespace taxel::ui
