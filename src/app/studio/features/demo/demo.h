// Moves the camera of the demo, repeats its run, and ends both.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/demo/demo_state.h"

namespace taxel::ui {

/// Advances the demo by `seconds`: the camera sways around its direction at the start, comes closer, and its target
/// follows the contact. When the scenario has ended, its recorded steps are played again and again. Does nothing unless
/// the demo runs in SIMULATE.
void advance_demo(WindowUi& ui, Viewer& viewer, const RunView& run, DemoState& demo, double seconds);

/// Ends the demo: the camera rests where it is, and the loop that the demo began ends with this round.
void end_demo(WindowUi& ui, DemoState& demo);

}  // namespace taxel::ui
