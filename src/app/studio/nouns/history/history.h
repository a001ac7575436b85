// The steps of the document's history as a list: a click undoes or redoes up to a step.
#pragma once

#include "app/studio/frame/feature.h"

namespace taxel::ui {

/// The steps of Undo.
extern const Feature kHistory;
}  // namespace taxel::ui
