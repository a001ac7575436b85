// Pauses the example of the paper's artifact at its first jump, and explains the jump.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/explain/hunt_state.h"

namespace taxel::ui {

/// Breaks on jumps at a constant force, and waits for the first one.
void begin_hunt(WindowUi& ui, HuntState& hunt);

/// When the run has stopped at a jump: selects the taxel and opens its explanation.
void follow_hunt(Viewer& viewer, const Shown& shown, HuntState& hunt, ExplainState& explain, bool& panel_is_open);

}  // namespace taxel::ui
