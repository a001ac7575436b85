// The 3-D view: draws the scene when something changed, and what floats over it.
#pragma once

#include "app/studio/app/ui_state.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {
void draw_view(UiState& ui, const UiInput& input, SceneRenderer& renderer);
}  // namespace taxel::ui
