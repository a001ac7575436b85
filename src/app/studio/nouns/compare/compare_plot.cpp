#include "app/studio/nouns/compare/compare_plot.h"

#include <fmt/format.h>
#include <implot.h>

#include <algorithm>
#include <iterator>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/nouns/compare/compare_tool.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_legend.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr float kMaxCompareLegend = 0.3f;  // largest part of the width that the legend takes
constexpr double kCurveReach = 12;         // distance at which the pointer is at a curve, at scale 1 [pixels]

/// Returns the curves that are drawn in full: the hovered one, otherwise the isolated ones. If both layouts have the
/// same taxels, each of them comes with the curve of the same taxel in the other layout. Empty if all curves are equal.
std::vector<TaxelKey> compared_focus(const ComparedLayouts& compared, const std::vector<ChosenCurve>& curves,
                                     const std::optional<TaxelKey>& hovered, const std::vector<TaxelKey>& isolated) {
  std::vector<TaxelKey> wanted = hovered ? std::vector{*hovered} : isolated;
  if (!compared.taxels_of_b)
    for (std::size_t i = 0, count = wanted.size(); i < count; ++i)
      wanted.push_back({1 - wanted[i].sensor, wanted[i].id});
  return focus_of(curves, std::nullopt, wanted);
}

PlotAxes compared_axes(const RunView& run, const ComparedLayouts& compared, const CompareState& compare,
                       bool relative) {
  PlotChoice both;
  both.unit = shown_unit(compared.a->layout.readout.aggregate);
  for (std::size_t s = 0; s < compare.sides.size(); ++s)
    if (compare.drawn[s]) both.largest = std::max(both.largest, compare.sides[s].summary.peak.value);
  PlotAxes axes = plot_axes(run, both, relative);
  if (relative) axes.y_name = "reading / largest of its layout";
  return axes;
}

/// Names the curve under the pointer with its value, and with the value of the same taxel in the other layout.
void draw_compared_tip(const RunView& run, const ComparedLayouts& compared, const CompareState& compare,
                       const TaxelKey& key, double x) {
  const PlotCurves& curves = compare.sides[0].curves;
  auto row = std::lower_bound(curves.x.begin(), curves.x.end(), x);
  if (row == curves.x.end() || (row != curves.x.begin() && x - *(row - 1) < *row - x)) --row;
  const std::string place = run.by_travel() ? fmt::format("{:.4g} mm", *row) : fmt::format("{:.4g} s", *row);
  std::string text = side_taxel(compared, key) + "\nat " + place + ": ";
  const auto value = [&](std::size_t side, std::size_t reading) {
    const SensorModelPtr& model = side == 0 ? compared.a : compared.b;
    return in_unit(compare.sides[side].curves.readings[reading][static_cast<std::size_t>(row - curves.x.begin())],
                   shown_unit(model->layout.readout.aggregate));
  };
  const auto side = static_cast<std::size_t>(key.sensor);
  const int taxel = index_of((side == 0 ? compared.a : compared.b)->layout, key.id);
  if (taxel < 0) return;
  text += value(side, static_cast<std::size_t>(taxel));
  if (!compared.taxels_of_b)
    text += fmt::format("\n{}: {}", side_taxel(compared, {1 - key.sensor, key.id}),
                        value(1 - side, static_cast<std::size_t>(taxel)));
  ImGui::SetTooltip("%s", text.c_str());
}

void draw_sides(WindowUi& ui, const ComparedLayouts& compared, CompareState& compare, bool relative) {
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    CompareSide& side = compare.sides[s];
    const double scale = side_scale(compared, s, side.summary, relative);
    for (const std::size_t i : drawing_order(compare.shown.curves[s], compare.shown.focus)) {
      const ChosenCurve& curve = compare.shown.curves[s][i];
      draw_plot_curve(ui, side.curves, curve, style_of(curve, compare.shown.focus), scale);
    }
  }
}

std::vector<ChosenCurve> fill_curves(const ComparedLayouts& compared, const Selection& selection,
                                     CompareState& compare) {
  std::vector<ChosenCurve> all;
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    std::vector<ChosenCurve>& curves = compare.shown.curves[s];
    if (compare.drawn[s])
      curves = choose_side(compared, s, compare.sides[s].summary, selection, compare.responding_only);
    std::copy(curves.begin(), curves.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

void draw_compare_plot(WindowUi& ui, Viewer& viewer, const RunView& run, const ComparedLayouts& compared,
                       CompareState& compare, ImVec2 size) {
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                          ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const std::vector<ChosenCurve> all = fill_curves(compared, viewer.selection, compare);
  const ImVec2 at = ImGui::GetCursorPos();
  const float legend = std::min(plot_legend_width(all), kMaxCompareLegend * size.x);
  ImGui::SetCursorPos({at.x + size.x - legend, at.y});
  const LegendPointer pointer =
      draw_plot_legend(ui, all, compare.isolated, {legend, size.y}, [&](const ChosenCurve& curve) {
        return side_taxel(compared, curve.key) + "\nClick: keep the other curves dim. Shift adds.";
      });
  if (pointer.clicked && pointer.clicked->sensor == 0)
    click_taxel(viewer.selection, pointer.clicked->id, ImGui::GetIO().KeyShift);
  const std::optional<TaxelKey> hovered = pointer.hovered ? pointer.hovered : compare.hovered;
  compare.shown.focus = compared_focus(compared, all, hovered, compare.isolated);
  compare.hovered.reset();
  ImGui::SetCursorPos(at);
  if (ImPlot::BeginPlot("##compared", {size.x - legend, size.y}, kFlags)) {
    const bool relative = is_relative(compared, compare);
    setup_plot_axes(compared_axes(run, compared, compare, relative), size.y);
    draw_sides(ui, compared, compare, relative);
    draw_plot_cursor(ui, run);
    if (ImPlot::IsPlotHovered()) {
      const ImPlotPoint mouse = ImPlot::GetPlotMousePos();
      const double reach = kCurveReach * ui.pixel_scale * ImPlot::GetPlotLimits().Y.Size() /
                           std::max(1.0, static_cast<double>(ImPlot::GetPlotSize().y));
      compare.hovered = nearest_curve(compare, compared, {mouse.x, mouse.y, reach});
      if (compare.hovered) draw_compared_tip(run, compared, compare, *compare.hovered, mouse.x);
    }
    if (const auto& named = pointer.hovered ? pointer.hovered : compare.hovered)
      compare.shown.hovered = side_taxel(compared, *named);
    scrub_in_plot(ui, run);
    ImPlot::EndPlot();
    ui.widgets.note_item("Compared curves");
  }
  ImGui::PopFont();
}

}  // namespace taxel::ui
