#include "app/studio/nouns/plot/plot_drawing.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/curve_colors.h"
#include "ui/theme.h"
#include "ui/widgets/dashed_curve.h"

namespace taxel::ui {

namespace {

/// Space above and below the vertical axis, in heights of text. The name of the axis is left out if it does not fit.
constexpr float kAroundAxis = 3.5f;

}  // namespace

void setup_plot_axes(const PlotAxes& axes, float height) {
  const bool tall = height - kAroundAxis * ImGui::GetFontSize() > ImGui::CalcTextSize(axes.y_name.c_str()).x;
  ImPlot::SetupAxes(axes.x_name.c_str(), tall ? axes.y_name.c_str() : nullptr,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0, axes.x_end, ImPlotCond_Always);
  ImPlot::SetupAxisLimits(ImAxis_Y1, 0, axes.y_end, ImPlotCond_Always);
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

}  // namespace taxel::ui
