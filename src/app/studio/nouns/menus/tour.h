// The tour of the window: five steps, each displayed next to the part that the step explains.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/tour_state.h"

namespace taxel::ui {

/// Shows the first step of the tour.
struct ShowTour {};
void carry_out(const ShowTour& command, App& app);

/// A short tour of the window.
extern const Feature kTour;
/// Sets "tour_step".
void dump_tour(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
