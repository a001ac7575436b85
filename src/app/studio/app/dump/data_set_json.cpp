// State dump of the panel of data sets.
#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/dump/scene_json.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/features/data_set/replay.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

Json set_json(const ui::DataSetState& state) {
  static const ui::OpenDataSet none;
  const ui::OpenDataSet& set = state.set ? *state.set : none;
  Json json{{"folder", set.folder},
            {"bits", set.bits},
            {"reading", state.is_reading},
            {"failed", set.failed},
            {"broken", set.broken},
            {"episodes", set.rows.size() - set.failed},
            {"listed", Json::array()},
            {"parameters", Json::array()},
            {"chosen", nullptr}};
  for (const std::size_t row : state.list.rows)
    json["listed"].push_back(set.rows[row].episode ? Json(*set.rows[row].episode) : Json(set.rows[row].error));
  for (const ui::DataSetParameter& parameter : set.parameters) json["parameters"].push_back(parameter.title);
  if (state.chosen) json["chosen"] = *state.chosen;
  return json;
}

}  // namespace

std::string data_set_to_state(const ui::App& app) {
  const ui::DataSetState& state = app.simulate->data_set;
  Json json = set_json(state);
  json["curves"] = nullptr;
  json["replay"] = nullptr;
  if (state.curves)
    json["curves"] = {{"episode", state.curves->from.episode},
                      {"rows", state.curves->readings.rows.size()},
                      {"largest", state.plots.readings.largest},
                      {"problem", state.curves->problem}};
  if (state.replayed)
    json["replay"] = {{"episode", state.replayed->from.episode}, {"rows", state.check.rows},
                      {"of", state.replayed->rows.rows},         {"different", state.check.different_rows},
                      {"largest", state.check.largest},          {"text", ui::replay_text(*app.shown, state)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
