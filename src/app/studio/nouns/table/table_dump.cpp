// The table of taxels in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/table/table_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_table(const App& app, nlohmann::ordered_json& state) {
  const TableState& table = app.get<TableState>();
  Json rows = Json::array();
  if (const Layout* layout = app.shown->layout(*app.viewer))
    for (const int row : table.rows)
      if (const auto i = static_cast<std::size_t>(row); i < layout->taxels.size()) rows.push_back(layout->taxels[i].id);
  Json sensor_rows = Json::array();
  const std::vector<SensorShown> sensors = sensors_shown(app.shown->run);
  for (const SensorRow& row : table.sensor_rows)
    if (row.sensor < sensors.size())
      sensor_rows.push_back({sensors[row.sensor].index, sensors[row.sensor].taxels()[row.taxel].id});
  state["table"] = {{"rows", rows},
                    {"sensor_rows", std::move(sensor_rows)},
                    {"filter", table.filter},
                    {"typing", table.cell.has_value()}};
}

}  // namespace taxel::ui
