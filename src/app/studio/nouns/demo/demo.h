// Moves the camera of the demo, repeats its run, and ends both.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo_state.h"

namespace taxel::ui {

/// Advances the demo by `seconds`: the camera sways around its direction at the start, comes closer, and its target
/// follows the contact. When the scenario has ended, its recorded steps are played again and again. Does nothing unless
/// the demo runs in SIMULATE.
void advance_demo(WindowUi& ui, Viewer& viewer, const RunView& run, DemoState& demo, double seconds);

/// Ends the demo: the camera rests where it is, and the loop that the demo began ends with this round.
void end_demo(WindowUi& ui, DemoState& demo);

/// The demo that runs by itself, with its caption.
extern const Feature kDemo;
/// Sets "demo" of the history of the simulation.
void dump_demo(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
