// The whole window of one frame: menus, toolbar, status line, docked panels, dialogs.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

struct App;

/// Between ImGui::NewFrame and ImGui::Render. Leaves the posted commands and the places of widgets in `app.ui`.
void draw_interface(App& app, SceneRenderer& renderer);

/// Ends the demo of the start, because the user acts.
void end_demo(App& app);
/// The run of the open document pauses at its first jump, which is explained at once.
void explain_first_jump(App& app);

}  // namespace taxel::ui
