// The panel of data sets in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

Json set_json(const DataSetState& panel) {
  static const OpenDataSet none;
  const OpenDataSet& set = panel.set ? *panel.set : none;
  Json json{{"folder", set.folder},
            {"bits", set.bits},
            {"reading", panel.is_reading},
            {"failed", set.failed},
            {"broken", set.broken},
            {"episodes", set.rows.size() - set.failed},
            {"listed", Json::array()},
            {"parameters", Json::array()},
            {"chosen", nullptr}};
  for (const std::size_t row : panel.list.rows)
    json["listed"].push_back(set.rows[row].episode ? Json(*set.rows[row].episode) : Json(set.rows[row].error));
  for (const DataSetParameter& parameter : set.parameters) json["parameters"].push_back(parameter.title);
  if (panel.chosen) json["chosen"] = *panel.chosen;
  return json;
}

}  // namespace

void dump_data_set(const App& app, nlohmann::ordered_json& state) {
  const DataSetState& panel = app.get<DataSetState>();
  Json json = set_json(panel);
  json["curves"] = nullptr;
  json["replay"] = nullptr;
  if (panel.curves)
    json["curves"] = {{"episode", panel.curves->from.episode},
                      {"rows", panel.curves->readings.rows.size()},
                      {"largest", panel.plots.readings.largest},
                      {"problem", panel.curves->problem}};
  if (panel.replayed)
    json["replay"] = {{"episode", panel.replayed->from.episode}, {"rows", panel.check.rows},
                      {"of", panel.replayed->rows.rows},         {"different", panel.check.different_rows},
                      {"largest", panel.check.largest},          {"text", replay_text(*app.shown, panel)}};
  state["data_set"] = std::move(json);
}

}  // namespace taxel::ui
