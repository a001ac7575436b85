// The problems of the layout and its painted region in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/inspector/inspector_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_inspector(const App& app, nlohmann::ordered_json& state) {
  Json json = Json::array();
  for (const Problem& problem : app.get<LayoutProblems>().list)
    json.push_back({{"severity", to_string(problem.severity)},
                    {"pointer", problem.pointer},
                    {"code", problem.code},
                    {"message", problem.message}});
  state["problems"] = std::move(json);
  const ProjectPtr& project = app.shown->document.editing.project;
  state["region"] = project ? Json(*project->layout.sampling.region) : Json(nullptr);
}

}  // namespace taxel::ui
