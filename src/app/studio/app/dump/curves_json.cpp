#include "app/studio/app/dump/curves_json.h"
#include "app/studio/app/values/simulate_features.h"

#include <nlohmann/json.hpp>

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

Json readout_json(const std::optional<ui::PlotReadout>& readout, const ui::ReadingUnit& unit) {
  if (!readout) return nullptr;
  Json lines = Json::array();
  for (const ui::PlotReadout::Line& line : readout->lines)
    lines.push_back({{"sensor", line.key.sensor},
                     {"taxel", line.key.id},
                     {"label", line.label},
                     {"text", ui::in_unit(line.value, unit)},
                     {"value", line.value}});
  return {{"x", readout->x}, {"lines", std::move(lines)}, {"omitted", readout->omitted}};
}

}  // namespace

std::string plot_to_json(const ui::App& app) {
  const ui::PlotShown& shown = app.simulate->plot.shown;
  Json curves = Json::array();
  for (const ui::ChosenCurve& curve : shown.choice.curves)
    curves.push_back({{"sensor", curve.key.sensor},
                      {"taxel", curve.key.id},
                      {"label", curve.label},
                      {"selected", curve.selected},
                      {"jumped", curve.jumped},
                      {"place", curve.place},
                      {"of", curve.of},
                      {"dimmed", ui::style_of(curve, shown.focus).dimmed},
                      {"dashed", ui::style_of(curve, shown.focus).dashes.has_value()}});
  return Json{{"curves", std::move(curves)},
              {"unit", shown.choice.unit.text},
              {"quantity", ui::words_of(shown.choice.quantity).key},
              {"largest", shown.choice.largest},
              {"isolated", app.simulate->plot.isolated.size()},
              {"errors", shown.errors},
              {"readout", readout_json(shown.readout, shown.choice.unit)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string heat_to_json(const ui::App& app) {
  const ui::HeatShown& shown = app.simulate->heat.shown;
  Json rows = Json::array();
  for (const ui::HeatRow& row : shown.rows) rows.push_back(row.label);
  Json hover = nullptr;
  if (const auto& cell = shown.hover)
    hover = {{"sensor", cell->key.sensor},
             {"taxel", cell->key.id},
             {"step", cell->step},
             {"time", cell->time},
             {"reading", cell->reading}};
  return Json{{"rows", std::move(rows)},
              {"row_height", shown.places.row},
              {"columns", shown.columns},
              {"runs", shown.runs},
              {"first_step", shown.first_step},
              {"last_step", shown.last_step},
              {"cells", {shown.cells.x0, shown.cells.y0, shown.cells.x1, shown.cells.y1}},
              {"hover", std::move(hover)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
