// The whole window of one frame: menus, toolbar, status line, docked panels, dialogs.
#pragma once

#include "app/studio/app/ui_state.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

/// Between ImGui::NewFrame and ImGui::Render. Leaves in `ui` what was asked, and where widgets stood.
void draw_interface(UiState& ui, const UiInput& input, SceneRenderer& renderer);

}  // namespace taxel::ui
