#include "app/studio/app/dump/compare_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/features/compare/compare_tool.h"
#include "core/layout/words.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

Json reading_json(const ui::RowReading& reading, const Layout& layout) {
  return {
      {"value", reading.value},
      {"taxel", reading.taxel >= 0 ? Json(layout.taxels[static_cast<std::size_t>(reading.taxel)].id) : Json(nullptr)},
      {"x", reading.x}};
}

Json side_json(const ui::App& app, const ui::ComparedLayouts& compared, std::size_t side) {
  const ui::CompareState& compare = app.simulate->compare;
  const Layout& layout = (side == 0 ? compared.a : compared.b)->layout;
  const ui::SideSummary& summary = compare.sides[side].summary;
  Json curves = Json::array();
  for (const ui::ChosenCurve& curve : compare.shown.curves[side])
    curves.push_back({{"taxel", curve.key.id},
                      {"label", curve.label},
                      {"dimmed", ui::style_of(curve, compare.shown.focus).dimmed},
                      {"dashed", ui::style_of(curve, compare.shown.focus).dashes.has_value()}});
  Json json{{"name", ui::side_name(compared, side)},
            {"taxels", layout.taxels.size()},
            {"unit", reading_unit(layout.readout.aggregate)},
            {"density", layout.sampling.density},
            {"field", to_word(layout.material.field)},
            {"modulus", layout.material.modulus},
            {"peak", reading_json(summary.peak, layout)},
            {"jump", reading_json(summary.jump, layout)},
            {"responding", summary.responding},
            {"rows", compare.sides[side].trace.rows.size()},
            {"curves", std::move(curves)}};
  if (compared.displayed) json["readings"] = compared.displayed->readings[side];
  return json;
}

}  // namespace

std::string compare_to_json(const ui::App& app) {
  const ui::CompareState& compare = app.simulate->compare;
  if (!compare.request) return "null";
  const ui::ComparedLayouts* compared =
      ui::displayed_comparison(*app.viewer, *app.shown, compare, app.window->panels.compare);
  Json json{{"file", compare.request->file},
            {"paper", compare.request->is_paper()},
            {"number", compare.request->number},
            {"contact", compare.request->contact == SecondContact::own ? "own" : "recorded"},
            {"busy", compare.progress.busy},
            {"stopped", compare.stopped},
            {"read", compare.progress.read},
            {"due", compare.progress.due},
            {"is_displayed", compared != nullptr && compared->b},
            {"problem", compared != nullptr ? compared->problem : ""},
            {"held", compare.shown.held},
            {"hovered", compare.shown.hovered},
            {"rings", ui::scene_input(app).ghosts ? ui::scene_input(app).ghosts->size() : 0}};
  if (compared != nullptr && compared->b) {
    json["reads_recorded"] = compared->reads_recorded;
    json["equal_contact"] = compared->equal_contact;
    json["rows"] = compared->rows.size();
    json["step"] = compared->displayed ? Json(compared->displayed->step) : Json(nullptr);
    json["relative"] = ui::is_relative(*compared, compare);
    json["sides"] = {side_json(app, *compared, 0), side_json(app, *compared, 1)};
    json["bars"] = Json::array();
    for (const ui::BarShown& bar : compare.shown.bars)
      json["bars"].push_back({{"b", bar.sensor < 0}, {"taxel", bar.taxel_id}, {"value", bar.value}, {"top", bar.top}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
