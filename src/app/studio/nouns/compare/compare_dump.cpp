// The comparison with a second layout in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "core/layout/words.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

Json reading_json(const RowReading& reading, const Layout& layout) {
  return {
      {"value", reading.value},
      {"taxel", reading.taxel >= 0 ? Json(layout.taxels[static_cast<std::size_t>(reading.taxel)].id) : Json(nullptr)},
      {"x", reading.x}};
}

Json side_json(const App& app, const ComparedLayouts& compared, std::size_t side) {
  const CompareState& compare = app.get<CompareState>();
  const Layout& layout = compared.of(side)->layout;
  const SideSummary& summary = compare.sides[side].summary;
  Json curves = Json::array();
  for (const ChosenCurve& curve : compare.shown.curves[side])
    curves.push_back({{"taxel", curve.key.id},
                      {"label", curve.label},
                      {"dimmed", style_of(curve, compare.shown.focus).dimmed},
                      {"dashed", style_of(curve, compare.shown.focus).dashes.has_value()}});
  Json json{{"name", side_name(compared, side)},
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
  if (compared.displayed) json["readings"] = side_readings(*compared.displayed, side);
  return json;
}

}  // namespace

void dump_compare(const App& app, nlohmann::ordered_json& state) {
  const CompareState& compare = app.get<CompareState>();
  state["compare"] = nullptr;
  if (!compare.request) return;
  const ComparedLayouts* compared =
      displayed_comparison(*app.viewer, *app.shown, compare, app.get<PanelsShown>()[kCompare]);
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
            {"rings", scene_input(app).ghosts ? scene_input(app).ghosts->size() : 0}};
  if (compared != nullptr && compared->b) {
    json["reads_recorded"] = compared->reads_recorded;
    json["equal_contact"] = compared->equal_contact;
    json["rows"] = compared->steps.size();
    json["step"] = compared->displayed ? Json(compared->displayed->step) : Json(nullptr);
    json["relative"] = is_relative(*compared, compare);
    json["sides"] = {side_json(app, *compared, 0), side_json(app, *compared, 1)};
    json["bars"] = Json::array();
    for (const BarShown& bar : compare.shown.bars.bars)
      json["bars"].push_back({{"b", bar.sensor < 0}, {"taxel", bar.taxel_id}, {"value", bar.value}, {"top", bar.top}});
  }
  state["compare"] = std::move(json);
}

}  // namespace taxel::ui
