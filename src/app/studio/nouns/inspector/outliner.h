// The outliner: a tree of the document's sensor and of the bodies of the running scene.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {
/// The sensors and bodies of the scene.
extern const Feature kOutliner;
}  // namespace taxel::ui
