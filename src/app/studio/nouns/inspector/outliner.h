// The outliner: a tree of the document's sensor and of the bodies of the running scene.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The sensors and bodies of the scene.
extern const Feature kOutliner;
}  // namespace taxel::ui
