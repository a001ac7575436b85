// The demo and the tour, which introduce the window to a newcomer. The demo is the start's fingertip sweep, played in a
// loop under a camera that sways around the contact. The tour has five steps, each displayed next to the part that the
// step explains.
#pragma once

#include <optional>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

struct DemoState {
  bool runs = false;            ///< whether the demo plays; the first key, click or turn of the wheel ends it
  double seconds = 0;           ///< time since the camera began to sway [s]
  std::optional<Camera> start;  ///< the camera when the sway began; empty before the contact is displayed
  bool invites = false;         ///< whether the caption with the next steps is displayed
  bool loops = false;           ///< whether the demo has begun the loop over the recorded steps
};

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

struct TourState {
  int step = -1;      ///< displayed step, or -1 if the tour is closed
  bool seen = false;  ///< whether the tour has ended once; stored in the settings file
};

/// Shows the first step of the tour.
struct ShowTour {};
void carry_out(const ShowTour& command, App& app);

/// The tour of the window.
extern const Feature kTour;
/// Sets "tour_step".
void dump_tour(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
