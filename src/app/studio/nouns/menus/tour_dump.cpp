// The tour in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/menus/tour.h"
#include "app/studio/nouns/menus/tour_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_tour(const App& app, nlohmann::ordered_json& state) {
  state["tour_step"] = app.get<TourState>().step;
}

}  // namespace taxel::ui
