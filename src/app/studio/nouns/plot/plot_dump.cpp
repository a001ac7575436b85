// The plot in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

Json readout_json(const std::optional<PlotReadout>& readout, const ReadingUnit& unit) {
  if (!readout) return nullptr;
  Json lines = Json::array();
  for (const PlotReadout::Line& line : readout->lines)
    lines.push_back({{"sensor", line.key.sensor},
                     {"taxel", line.key.id},
                     {"label", line.label},
                     {"text", in_unit(line.value, unit)},
                     {"value", line.value}});
  return {{"x", readout->x}, {"lines", std::move(lines)}, {"omitted", readout->omitted}};
}

Json close_up_json(const PlotState& plot) {
  if (!plot.close_up || !plot.shown.close_up) return nullptr;
  const CloseUpView& view = *plot.shown.close_up;
  const CurveBounds& bounds = view.bounds;
  return {{"sensor", plot.close_up->key.sensor},
          {"taxel", plot.close_up->key.id},
          {"step", plot.close_up->step},
          {"change_pixels", plot.shown.change_pixels},
          {"x", {bounds.x_low, bounds.x_high}},
          {"y", {bounds.y_low, bounds.y_high}},
          {"readings", view.readings.y},
          {"exact", view.exact.y},
          {"before", view.before.y}};
}

}  // namespace

void dump_plot(const App& app, nlohmann::ordered_json& state) {
  const PlotShown& shown = app.get<PlotState>().shown;
  Json curves = Json::array();
  for (const ChosenCurve& curve : shown.choice.curves)
    curves.push_back({{"sensor", curve.key.sensor},
                      {"taxel", curve.key.id},
                      {"label", curve.label},
                      {"selected", curve.selected},
                      {"jumped", curve.jumped},
                      {"place", curve.place},
                      {"of", curve.of},
                      {"dimmed", style_of(curve, shown.focus).dimmed},
                      {"dashed", style_of(curve, shown.focus).dashes.has_value()}});
  Json legend = Json::array();
  for (const LegendEntry& entry : legend_entries(shown.choice.curves)) legend.push_back(entry.label);
  state["plot"] = {{"legend", std::move(legend)},
                   {"fits_contact", shown.fits_contact},
                   {"answer", shown.answer},
                   {"x", {shown.x_begin, shown.x_end}},
                   {"curves", std::move(curves)},
                   {"unit", shown.choice.unit.text},
                   {"quantity", words_of(shown.choice.quantity).key},
                   {"largest", shown.choice.largest},
                   {"isolated", app.get<PlotState>().isolated.size()},
                   {"errors", shown.errors},
                   {"close_up", close_up_json(app.get<PlotState>())},
                   {"before", shown.before != nullptr},
                   {"readout", readout_json(shown.readout, shown.choice.unit)}};
}

}  // namespace taxel::ui
