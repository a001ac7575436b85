// The scenario in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/vector_json.h"
#include "core/document/scenario/scenario.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_scenario(const App& app, nlohmann::ordered_json& state) {
  const Scenario* edited = edited_scenario(*app.viewer, *app.shown);
  state["scenario"] = nullptr;
  if (edited == nullptr) return;
  Json json = {
      {"edited", Json::parse(scenario_to_json(*edited))},
      {"running", Json::parse(scenario_to_json(app.shown->run.scenario))},
      {"selected", app.get<PathState>().selected},
      {"recorded", app.get<PathState>().recording ? Json(app.get<PathState>().recording->points.size()) : Json()},
      {"way_points", Json::array()}};
  if (const auto path = edited_path(*app.viewer, *app.shown, app.get<PathState>())) {
    for (const dvec3& p_W : path->points_W) {
      const dvec3 pixel = app.viewer->project(p_W);
      json["way_points"].push_back({{"at", numbers<Json>(p_W)},
                                    {"pixel",
                                     {pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                                      pixel.y + static_cast<double>(app.viewer->view.rect.y0)}}});
    }
  }
  state["scenario"] = std::move(json);
}

}  // namespace taxel::ui
