#include "app/studio/app/dump/editing_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/menus/menu_bar.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/vector_json.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

const char* to_string(ui::Tool tool) {
  switch (tool) {
    case ui::Tool::none:
      return "none";
    case ui::Tool::place:
      return "place";
    case ui::Tool::slide:
      return "slide";
    case ui::Tool::move:
      return "move";
    case ui::Tool::turn:
      return "turn";
    case ui::Tool::resize:
      return "resize";
    case ui::Tool::way_point:
      return "way_point";
    case ui::Tool::box:
      return "box";
    case ui::Tool::lasso:
      return "lasso";
    case ui::Tool::brush:
      return "brush";
  }
  return "none";
}

Json tool_json(const ui::ToolState& tool) {
  return {{"name", to_string(tool.tool)}, {"value", tool.value}, {"problem", tool.problem}};
}

/// Returns the refused input of a field, or null if no input is refused.
Json refused_json(const ui::FieldState& fields) {
  if (!fields.refused) return nullptr;
  return {
      {"field", fields.refused->input.field}, {"typed", fields.refused->input.typed}, {"words", fields.refused->words}};
}

/// Returns the rows of the table in displayed order, and whether a cell is being edited.
Json table_json(const ui::App& app) {
  Json rows = Json::array();
  if (const Layout* layout = app.shown->layout(*app.viewer))
    for (const int row : app.layout->table.rows)
      if (const auto i = static_cast<std::size_t>(row); i < layout->taxels.size()) rows.push_back(layout->taxels[i].id);
  Json sensor_rows = Json::array();
  const std::vector<ui::SensorShown> sensors = ui::sensors_shown(app.shown->run);
  for (const ui::SensorRow& row : app.layout->table.sensor_rows)
    if (row.sensor < sensors.size())
      sensor_rows.push_back({sensors[row.sensor].index, sensors[row.sensor].taxels()[row.taxel].id});
  return {{"rows", rows},
          {"sensor_rows", std::move(sensor_rows)},
          {"filter", app.layout->table.filter},
          {"typing", app.layout->table.cell.has_value()}};
}

Json problems_json(const ui::LayoutProblems& problems) {
  Json json = Json::array();
  for (const Problem& problem : problems.list)
    json.push_back({{"severity", to_string(problem.severity)},
                    {"pointer", problem.pointer},
                    {"code", problem.code},
                    {"message", problem.message}});
  return json;
}

/// Returns the state of the Generate panel, or null while the panel is closed.
Json generate_json(const ui::GenerateState& g) {
  if (!g.open) return nullptr;
  Json json = {{"center", numbers<Json>(g.frame.center)},
               {"normal", numbers<Json>(g.frame.normal)},
               {"turn_deg", g.pattern.turn_deg},
               {"waiting", g.waiting()},
               {"left_out", g.left_out},
               {"least_distance", nullptr},
               {"problem", g.problem},
               {"file_problem", g.file_problem},
               {"taxels", Json::array()}};
  if (std::isfinite(g.least_distance)) json["least_distance"] = g.least_distance;
  if (!g.ghosts) return json;
  for (const Taxel& taxel : *g.ghosts)
    json["taxels"].push_back({{"id", taxel.id},
                              {"center", numbers<Json>(taxel.center)},
                              {"normal", numbers<Json>(taxel.normal)},
                              {"radius", taxel.radius}});
  return json;
}

}  // namespace

std::string editing_to_json(const ui::App& app) {
  Json json = Json::object();
  json["tool"] = tool_json(app.layout->tool);
  json["refused"] = refused_json(app.ui->fields);
  json["keyboard"] = app.ui->fields.keyboard_panel;
  json["menus"] = {{"keyboard", app.window->menu_keys.on}, {"open", ui::open_menu(app)}};
  json["table"] = table_json(app);
  json["problems"] = problems_json(app.layout->problems);
  json["generate"] = generate_json(app.layout->generate);
  json["tour_step"] = app.window->tour.step;
  json["region"] = app.shown->document.editing.project
                       ? Json(*app.shown->document.editing.project->layout.sampling.region)
                       : Json(nullptr);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // messages may quote invalid UTF-8
}

}  // namespace taxel::studio
