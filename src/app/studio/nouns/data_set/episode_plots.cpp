#include "app/studio/nouns/data_set/episode_plots.h"

#include <fmt/format.h>
#include <implot.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/studio/nouns/plot/plot_choice.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_legend.h"
#include "core/document/scenario/scenario.h"
#include "core/sensor/readout/reading.h"
#include "ui/curve_colors.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr auto kEpisodePlotFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                                   ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
constexpr float kWidestLegend = 0.35f;               // largest part of a plot's width that its legend takes
constexpr std::size_t kTipLines = 8;                 // largest number of curves in the tooltip
constexpr float kLeastWidth = 22, kLeastHeight = 7;  // sizes of one plot, in heights of text

/// Returns the number of a taxel's colour: that of the document if its layout has the same taxels.
int color_of(const DocumentView& document, const DataSetLayout& layout, std::size_t taxel) {
  const auto own = static_cast<int>(taxel);
  if (!document.model || document.model->layout.taxels.size() != layout.taxel_ids.size()) return own;
  return document.model->color(own);
}

std::vector<ChosenCurve> chosen_readings(const DocumentView& document, const DataSetLayout& layout,
                                         const PlotCurves& curves) {
  std::vector<ChosenCurve> chosen;
  for (std::size_t k = 0; k < curves.readings.size() && k < layout.taxel_ids.size(); ++k) {
    if (!(curves.peaks[k] > kTaxelResponds * curves.largest)) continue;
    ChosenCurve curve;
    curve.key = {0, static_cast<int>(layout.taxel_ids[k])};
    curve.reading = k;
    curve.label = fmt::format("{}", layout.taxel_ids[k]);
    curve.color = color_of(document, layout, k);
    chosen.push_back(std::move(curve));
  }
  return chosen;
}

std::vector<ChosenCurve> chosen_forces(const PlotCurves& curves) {
  constexpr std::array kNames{"x", "y", "z"};
  constexpr std::array kColors{0, 2, 1};  // red, green and blue of the palette of taxels
  std::vector<ChosenCurve> chosen;
  for (std::size_t k = 0; k < kNames.size() && k < curves.readings.size(); ++k) {
    ChosenCurve curve;
    curve.key = {1, static_cast<int>(k)};
    curve.reading = k;
    curve.label = kNames[k];
    curve.color = kColors[k];
    chosen.push_back(std::move(curve));
  }
  return chosen;
}

/// One of the two plots.
struct EpisodePlot {
  const char* name;
  PlotCurves& curves;
  const std::vector<ChosenCurve>& chosen;
  ReadingUnit unit;
  std::string y_name;
  double low = 0, high = 1;  ///< ends of the vertical axis, in the displayed unit
  bool names_x = true;       ///< the horizontal axis has its name
};

void draw_value_tip(const WindowUi& ui, const EpisodePlot& plot, const std::vector<TaxelKey>& focus) {
  if (!ImPlot::IsPlotHovered()) return;
  PlotChoice choice;
  choice.curves = plot.chosen;
  choice.unit = plot.unit;
  const auto readout = read_curves(plot.curves, choice, focus, ImPlot::GetPlotMousePos().x, kTipLines);
  if (!readout || !ImGui::BeginTooltip()) return;
  ImGui::TextUnformatted(fmt::format("{:.4g} {}", readout->x, plot.curves.by_travel ? "mm" : "s").c_str());
  for (const PlotReadout::Line& line : readout->lines) {
    ImGui::TextColored(curve_color(line.color, ui.dark), "%s", line.label.c_str());
    ImGui::SameLine();
    ImGui::TextUnformatted(in_unit(line.value, plot.unit).c_str());
  }
  if (readout->omitted > 0) ImGui::TextDisabled("%zu more", readout->omitted);
  ImGui::EndTooltip();
}

void draw_plot(WindowUi& ui, const EpisodePlot& plot, std::vector<TaxelKey>& isolated, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorPos();
  const float legend = std::min(plot_legend_width(plot.chosen), kWidestLegend * size.x);
  ImGui::PushID(plot.name);
  ImGui::SetCursorPos({at.x + size.x - legend, at.y});
  const LegendPointer pointer = draw_plot_legend(
      ui, plot.chosen, isolated, {legend, size.y},
      [&](const ChosenCurve& curve) { return curve.label + "\nClick: keep the other curves dim. Shift adds."; });
  const std::vector<TaxelKey> focus = focus_of(plot.chosen, pointer.hovered, isolated);
  ImGui::SetCursorPos(at);
  if (ImPlot::BeginPlot("##plot", {size.x - legend, size.y}, kEpisodePlotFlags)) {
    constexpr auto kAxis = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight;
    const double end = plot.curves.x.empty() ? 1 : std::max(1e-9, plot.curves.x.back());
    const char* const x_name = plot.curves.by_travel ? "travel (mm)" : "time (s)";
    ImPlot::SetupAxes(plot.names_x ? x_name : nullptr, plot.y_name.c_str(), kAxis, kAxis);
    ImPlot::SetupAxisLimits(ImAxis_X1, 0, end, ImPlotCond_Always);
    ImPlot::SetupAxisLimits(ImAxis_Y1, plot.low, plot.high, ImPlotCond_Always);
    ImPlot::SetupFinish();
    for (const std::size_t i : drawing_order(plot.chosen, focus))
      draw_plot_curve(ui, plot.curves, plot.chosen[i], style_of(plot.chosen[i], focus), plot.unit.scale);
    draw_value_tip(ui, plot, focus);
    ImPlot::EndPlot();
    ui.widgets.note_item(plot.name);
  }
  ImGui::PopID();
}

void update_plots(EpisodePlots& plots, const EpisodeCurvesPtr& curves, bool by_travel) {
  if (plots.from == curves) return;
  plots = {};
  plots.from = curves;
  update_curves(plots.readings, curves->readings, by_travel);
  update_curves(plots.forces, curves->forces, by_travel);
}

/// Returns the smallest and the largest component of the force, with 0 between them [N].
std::pair<double, double> range_of(const PlotCurves& forces) {
  double low = 0, high = 0;
  for (const std::vector<double>& component : forces.readings)
    for (const double value : component) low = std::min(low, value), high = std::max(high, value);
  const double margin = 0.08 * std::max(high - low, 1e-6);
  return {low < 0 ? low - margin : 0, high > 0 ? high + margin : low < 0 ? margin : 1};
}

}  // namespace

void draw_episode_plots(WindowUi& ui, const DocumentView& document, DataSetState& state, ImVec2 size) {
  const EpisodeRow& row = state.set->rows[*state.chosen];
  const EpisodeCurvesPtr& curves = state.curves;
  if (!row.layout || !curves || curves->from.episode != row.episode || curves->from.folder != state.set->folder) return;
  update_plots(state.plots, curves, row.scenario == scenarios::Sweep::kWord);
  const DataSetLayout& layout = state.set->layouts[*row.layout];
  EpisodePlots& plots = state.plots;
  const ReadingUnit unit = shown_unit(layout.aggregate), newton{"N", 1, false};
  const auto [low, high] = range_of(plots.forces);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize();
  const bool is_wide = 0.5f * size.x > kLeastWidth * line || size.y < 2 * kLeastHeight * line;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 one = is_wide ? ImVec2(0.5f * (size.x - gap), size.y) : ImVec2(size.x, 0.5f * (size.y - gap));
  const std::vector<ChosenCurve> readings = chosen_readings(document, layout, plots.readings),
                                 forces = chosen_forces(plots.forces);
  const double top = unit.scale * axis_top(plots.readings.largest, unit);
  const ImVec2 at = ImGui::GetCursorPos();
  draw_plot(ui,
            {"Readings of the episode", plots.readings, readings, unit, fmt::format("reading ({})", unit.text), 0, top,
             is_wide},
            plots.isolated, one);
  ImGui::SetCursorPos(is_wide ? ImVec2(at.x + one.x + gap, at.y) : ImVec2(at.x, at.y + one.y + gap));
  draw_plot(ui, {"Force of the episode", plots.forces, forces, newton, "force (N)", low, high, true}, plots.isolated,
            one);
  ImGui::PopFont();
}

}  // namespace taxel::ui
