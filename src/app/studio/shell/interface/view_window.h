// The window of the 3-D view: the scene, the pointer in it and the text over it.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

struct App;

void draw_view(App& app, SceneRenderer& renderer);
}  // namespace taxel::ui
