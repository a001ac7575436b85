#include "app/studio/nouns/plot/plot_drawing.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plot_curves.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

/// Space above and below the vertical axis, in heights of text. The name of the axis is left out if it does not fit.
constexpr float kAroundAxis = 3.5f;

}  // namespace

const QuantityWords& words_of(PlotQuantity quantity) {
  static constexpr QuantityWords kWords[] = {
      {"reading", "Reading", "reading", "Readings of the taxels"},
      {"shear", "Shear", "shear", "Magnitude of the shear of each taxel, in the unit of its readings"},
      {"slip", "Slip", "field that slips", "Share of each taxel's touched field that slips, 0 to 100 %"}};
  return kWords[static_cast<std::size_t>(quantity)];
}

void setup_plot_axes(const PlotAxes& axes, float height) {
  const bool tall = height - kAroundAxis * ImGui::GetFontSize() > ImGui::CalcTextSize(axes.y_name.c_str()).x;
  ImPlot::SetupAxes(axes.x_name.c_str(), tall ? axes.y_name.c_str() : nullptr,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight);
  ImPlot::SetupAxisLimits(ImAxis_X1, axes.x_begin, axes.x_end, ImPlotCond_Always);
  ImPlot::SetupAxisLimits(ImAxis_Y1, axes.y_begin, axes.y_end, ImPlotCond_Always);
  ImPlot::SetupFinish();
}

void draw_plot_curve(const WindowUi& ui, PlotCurves& curves, const ChosenCurve& curve, const CurveStyle& style,
                     double scale) {
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  const double column = limits.X.Size() / std::max(1.0f, pixels.x), height = limits.Y.Size() / std::max(1.0f, pixels.y);
  const CurvePoints& whole = drawn_curve(curves, curve.reading, column, kCurveTolerance * height, scale);
  CurvePoints dashes;
  if (style.dashes)
    dashes = dashes_of(whole, 1 / column, 1 / height,
                       {style.dashes->dash * ui.pixel_scale, style.dashes->gap * ui.pixel_scale,
                        style.dashes->start * ui.pixel_scale});
  const CurvePoints& drawn = style.dashes ? dashes : whole;
  ImPlotSpec spec;
  spec.LineColor = curve_color(curve.color, ui.dark);
  if (style.dimmed) spec.LineColor.w = kDimmedAlpha;
  spec.LineWeight = static_cast<float>(style.width * ui.pixel_scale);
  ImPlot::PlotLine(fmt::format("{}##{} {}", curve.label, curve.key.sensor, curve.key.id).c_str(), drawn.x.data(),
                   drawn.y.data(), static_cast<int>(drawn.x.size()), spec);
}

int draw_plot_errors(const WindowUi& ui, const RunView& run, const std::vector<SensorShown>& sensors,
                     const std::vector<ChosenCurve>& curves, double scale) {
  const double x = run.by_travel() ? 1e3 * run.frame->travel : run.frame->time;
  const auto pixel = static_cast<float>(ui.pixel_scale);
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  int drawn = 0;
  ImPlot::PushPlotClipRect();
  for (const ChosenCurve& curve : curves) {
    const auto of_curve = std::find_if(sensors.begin(), sensors.end(),
                                       [&](const SensorShown& sensor) { return sensor.index == curve.key.sensor; });
    if (of_curve == sensors.end()) continue;
    const std::span<const double> errors = run.error_bars(of_curve->index);
    const std::size_t taxel = curve.reading - of_curve->first;
    if (taxel >= errors.size() || !(errors[taxel] > 0)) continue;
    const double value = of_curve->step->readings[taxel];
    const ImVec2 lo = ImPlot::PlotToPixels(x, scale * (value - errors[taxel])),
                 hi = ImPlot::PlotToPixels(x, scale * (value + errors[taxel]));
    const float at = std::round(lo.x) + (static_cast<float>(drawn % 5) - 2) * 4 * pixel, half = 3 * pixel;
    const ImU32 color = to_u32(curve_color(curve.color, ui.dark));
    list.AddLine({at, lo.y}, {at, hi.y}, color, 1.5f * pixel);
    list.AddLineH(at - half, at + half, lo.y, color, 1.5f * pixel);
    list.AddLineH(at - half, at + half, hi.y, color, 1.5f * pixel);
    ++drawn;
  }
  ImPlot::PopPlotClipRect();
  return drawn;
}

void draw_plot_cursor(const WindowUi& ui, const RunView& run) {
  const double x = run.by_travel() ? 1e3 * run.frame->travel : run.frame->time;
  ImPlotSpec spec;
  spec.LineColor = palette(ui.dark).path;
  spec.LineWeight = 1.2f;
  spec.Flags = ImPlotItemFlags_NoLegend | ImPlotItemFlags_NoFit;
  ImPlot::PlotInfLines("##now", &x, 1, spec);
}

void scrub_in_plot(WindowUi& ui, const RunView& run) {
  const HistoryLanes* lanes = run.frame->history.lanes.get();
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize(), at = ImGui::GetIO().MouseClickedPos[0];
  const bool began_here = at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y &&
                          ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (lanes == nullptr || lanes->rows() == 0 || !began_here ||
      !(ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseDragging(ImGuiMouseButton_Left)))
    return;
  const double x = ImPlot::GetPlotMousePos().x;
  const std::size_t row =
      run.by_travel() ? nearest_row(*lanes, &StepMark::travel, 1e-3 * x) : nearest_row(*lanes, &StepMark::time, x);
  const std::uint64_t step = lanes->steps[row].step;
  if (step != run.frame->step || run.playing) ui.post(ScrubTo{step});
}

namespace {

constexpr float kLegendSwatch = 1.9f, kLegendGap = 0.4f;  // in heights of text

/// Draws a piece of the curve: a line, or dashes over a grey line if the curve lies on another one. With `is_over_twin`
/// the line of the other one is drawn already.
void draw_swatch_line(const WindowUi& ui, const ChosenCurve& curve, const CurveStyle& style, ImVec2 from, float width,
                      bool is_over_twin) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  const ImU32 color = to_u32(curve_color(curve.color, ui.dark), style.dimmed ? kDimmedAlpha : 1.0f);
  const auto scale = static_cast<float>(ui.pixel_scale);
  const float weight = std::min(4.0f, static_cast<float>(style.width)) * scale;
  if (!style.dashes && !is_over_twin) return list.AddLine(from, {from.x + width, from.y}, color, weight);
  if (!is_over_twin) list.AddLine(from, {from.x + width, from.y}, to_u32(colors.line), weight);
  const float dash = width / 5;
  for (float x = 0; x < width; x += 2 * dash)
    list.AddLine({from.x + x, from.y}, {from.x + x + dash, from.y}, color, weight);
}

/// Draws a triangle that marks the taxel at which the simulation stopped.
void draw_stop_mark(const WindowUi& ui, ImVec2 center, float r) {
  ImGui::GetWindowDrawList()->AddTriangleFilled({center.x, center.y - r}, {center.x + r, center.y + 0.8f * r},
                                                {center.x - r, center.y + 0.8f * r}, to_u32(palette(ui.dark).warning));
}

}  // namespace

std::string legend_tip(const ChosenCurve& curve) {
  std::string tip = "Taxel " + curve.label;
  if (curve.jumped) tip += "\nThe simulation stopped at this taxel.";
  if (curve.of > 1)
    tip += fmt::format("\nIts curve lies on {} other{}; \"=\" joins those that agree within {:g} % of their peak.",
                       curve.of - 1, curve.of > 2 ? "s" : "", 100 * kEqualCurves);
  return tip + "\nClick: keep the other curves dim, and select the taxel. Shift adds.";
}

float plot_legend_width(const std::vector<ChosenCurve>& curves) {
  float widest = 0;
  for (const LegendEntry& entry : legend_entries(curves))
    widest = std::max(widest, ImGui::CalcTextSize(entry.label.c_str()).x);
  const float line = ImGui::GetFontSize();
  return widest + (kLegendSwatch + 3 * kLegendGap + 0.8f) * line + ImGui::GetStyle().ScrollbarSize;
}

namespace {

/// Draws the swatch, the label and the mark of an entry into its row.
void draw_legend_row(const WindowUi& ui, const std::vector<ChosenCurve>& curves, const LegendEntry& entry,
                     const std::vector<TaxelKey>& focus, ImVec2 at, float height, float width) {
  const float line = ImGui::GetFontSize(), middle = std::round(at.y + 0.5f * height);
  bool jumped = false;
  for (const std::size_t i : entry.curves) {
    const bool is_over_twin = i != entry.curves.front();
    draw_swatch_line(ui, curves[i], style_of(curves[i], focus), {at.x + kLegendGap * line, middle},
                     kLegendSwatch * line, is_over_twin);
    jumped = jumped || curves[i].jumped;
  }
  const float text_x = at.x + (kLegendSwatch + 2 * kLegendGap) * line;
  const float room = at.x + width - text_x - (jumped ? 1.1f * line : 0.0f);
  const std::string label = shortened(entry.label, room, 1);
  const bool dimmed = style_of(curves[entry.curves.front()], focus).dimmed;
  ImGui::GetWindowDrawList()->AddText({text_x, at.y + 1}, to_u32(dimmed ? palette(ui.dark).dim : palette(ui.dark).text),
                                      label.c_str());
  if (jumped) draw_stop_mark(ui, {text_x + ImGui::CalcTextSize(label.c_str()).x + 0.6f * line, middle}, 0.35f * line);
}

}  // namespace

LegendPointer draw_plot_legend(WindowUi& ui, const std::vector<ChosenCurve>& curves, std::vector<TaxelKey>& isolated,
                               ImVec2 size, const std::function<std::string(const ChosenCurve&)>& tip) {
  LegendPointer pointer;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginChild("##legend", size)) {
    const float row = ImGui::GetTextLineHeight() + 2;
    const std::vector<TaxelKey> focus = focus_of(curves, std::nullopt, isolated);
    for (const LegendEntry& entry : legend_entries(curves)) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float width = ImGui::GetContentRegionAvail().x;
      const ChosenCurve& first = curves[entry.curves.front()];
      bool kept = false, selected = false;
      for (const std::size_t i : entry.curves) {
        kept = kept || std::find(isolated.begin(), isolated.end(), curves[i].key) != isolated.end();
        selected = selected || curves[i].selected;
      }
      if (ImGui::Selectable(fmt::format("##curve {} {}", first.key.sensor, first.key.id).c_str(), kept || selected, 0,
                            ImVec2(0, row))) {
        click_isolated(isolated, first.key, ImGui::GetIO().KeyShift);
        if (!kept) pointer.clicked = first.key;
      }
      if (ImGui::IsItemHovered()) pointer.hovered = first.key;
      for (const std::size_t i : entry.curves) ui.widgets.note_item("Curve " + curves[i].label);
      draw_legend_row(ui, curves, entry, focus, at, row, width);
      tooltip(tip(first));
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  return pointer;
}

}  // namespace taxel::ui
