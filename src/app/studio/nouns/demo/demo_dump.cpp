// The demo and the tour in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/demo/demo_state.h"

namespace taxel::ui {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_demo(const App& app, nlohmann::ordered_json& state) {
  const DemoState& demo = app.get<DemoState>();
  if (app.shown->run.frame) state["simulation"]["history"]["demo"] = Json{{"runs", demo.runs}, {"loops", demo.loops}};
}

void dump_tour(const App& app, nlohmann::ordered_json& state) {
  state["tour_step"] = app.get<TourState>().step;
}

}  // namespace taxel::ui
