// The displayed explanation in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/sensor/explain/explanation.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_explanation(const App& app, nlohmann::ordered_json& state) {
  const Explanation* found =
      shown_explanation(*app.viewer, *app.shown, app.get<ExplainState>(), is_in_use(kExplain, app));
  state["explain"] = nullptr;
  state["runs_ahead"] = app.get<RunAhead>().phase != RunAhead::Phase::none;
  state["runs_ahead_hint"] = run_ahead_hint(*app.shown, app.get<RunAhead>());
  if (found == nullptr) return;
  Json json = Json::parse(explanation_to_json(*found));
  json["step"] = app.shown->run.frame->step;
  json["step_before"] = app.shown->run.frame->before ? Json(app.shown->run.frame->before->step) : Json(nullptr);
  json["ghost"] = app.get<ViewShown>().input.before != nullptr;
  json["selected_polygon"] = nullptr;
  if (app.get<ExplainState>().polygon)
    json["selected_polygon"] = {app.get<ExplainState>().polygon->surface, app.get<ExplainState>().polygon->polygon};
  state["explain"] = std::move(json);
}

}  // namespace taxel::ui
