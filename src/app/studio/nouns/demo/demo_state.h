// The demo and the tour, which introduce the window to a newcomer. The demo is the start's fingertip sweep over its
// contact, played in a loop under a camera that is near the contact and sways around it. The tour has five steps, each
// displayed next to the part that the step explains.
#pragma once

#include <optional>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "core/document/scenario/scenario.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

struct DemoState {
  bool runs = false;            ///< whether the demo plays: until the user pauses, or shows something else
  bool begun = false;           ///< whether the run of the demo has been displayed
  bool loops = false;           ///< whether the demo has begun the loop over the recorded contact
  bool replays = false;         ///< whether the loop has been displayed
  bool invites = false;         ///< whether the caption with the next steps is displayed
  bool leads = true;            ///< whether the demo moves the camera: until the first deliberate input
  double seconds = 0;           ///< time since the camera began to sway [s]
  double rests = 0;             ///< time since the run has stopped by itself or by the user [s]
  std::optional<Camera> start;  ///< the camera when the sway began; empty before the contact is displayed
};

/// Returns the scenario of the demo: the default sweep, from just before the edge to just behind the edge.
[[nodiscard]] Scenario demo_scenario();

/// Returns the recorded steps from 1 mm of travel before the first touch to 1 mm after the last touch, or all recorded
/// steps if nothing was touched.
[[nodiscard]] StepRange contact_steps(const HistoryState& history);

/// Advances the demo by `seconds`: the camera is near the contact, sways around it and follows it. When the scenario
/// has ended, its contact_steps() are played again and again, slowly. The demo ends when the user pauses, shows another
/// step or leaves SIMULATE.
void advance_demo(WindowUi& ui, Viewer& viewer, const RunView& run, DemoState& demo, double seconds);

/// Ends the demo: the displayed step stays, its loop and its speed end.
void end_demo(WindowUi& ui, const RunView& run, DemoState& demo);

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
