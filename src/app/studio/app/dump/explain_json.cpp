#include "app/studio/app/dump/explain_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/features/explain/explain_tool.h"
#include "core/sensor/explain/explanation_json.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string explain_to_json(const ui::App& app) {
  const Explanation* found =
      ui::shown_explanation(*app.viewer, *app.shown, app.simulate->explain, app.window->panels.explain);
  if (found == nullptr) return "null";
  Json json = Json::parse(explanation_to_json(*found));
  json["step"] = app.shown->run.frame->step;
  json["step_before"] = app.shown->run.frame->before ? Json(app.shown->run.frame->before->step) : Json(nullptr);
  json["ghost"] = app.window->view.input.before != nullptr;
  json["selected_polygon"] = nullptr;
  if (app.simulate->explain.polygon)
    json["selected_polygon"] = {app.simulate->explain.polygon->surface, app.simulate->explain.polygon->polygon};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
