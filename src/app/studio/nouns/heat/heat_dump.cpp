// The heat map in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/heat/heat_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_heat_map(const App& app, nlohmann::ordered_json& state) {
  const HeatShown& shown = app.get<HeatState>().shown;
  Json rows = Json::array();
  for (const HeatRow& row : shown.rows) rows.push_back(row.label);
  Json hover = nullptr;
  if (const auto& cell = shown.hover)
    hover = {{"sensor", cell->key.sensor},
             {"taxel", cell->key.id},
             {"step", cell->step},
             {"time", cell->time},
             {"reading", cell->reading}};
  state["heat"] = {{"rows", std::move(rows)},
                   {"row_height", shown.places.row},
                   {"columns", shown.columns},
                   {"runs", shown.runs},
                   {"first_step", shown.first_step},
                   {"last_step", shown.last_step},
                   {"cells", {shown.cells.x0, shown.cells.y0, shown.cells.x1, shown.cells.y1}},
                   {"hover", std::move(hover)}};
}

}  // namespace taxel::ui
