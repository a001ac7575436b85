// The outliner: a tree of the document's sensor and of the bodies of the running scene.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"

namespace taxel::ui {
void draw_outliner(WindowUi& ui, Selection& selection, const Shown& shown, PanelsShown& panels);
}  // namespace taxel::ui
