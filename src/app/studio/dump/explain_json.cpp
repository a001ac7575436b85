#include "app/studio/dump/explain_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/features/explain/explain_tool.h"
#include "core/sensor/explain/explanation_json.h"

namespace taxel::studio {

std::string explain_to_json(const ui::UiState& ui, const ui::UiInput& input) {
  using Json = nlohmann::ordered_json;
  const Explanation* found = ui::shown_explanation(ui, input);
  if (found == nullptr) return "null";
  Json json = Json::parse(explanation_to_json(*found));
  json["step"] = input.frame->step;
  json["step_before"] = input.frame->before ? Json(input.frame->before->step) : Json(nullptr);
  json["ghost"] = ui.view.input.before != nullptr;
  json["selected_polygon"] = nullptr;
  if (ui.explain.polygon) json["selected_polygon"] = {ui.explain.polygon->surface, ui.explain.polygon->polygon};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
