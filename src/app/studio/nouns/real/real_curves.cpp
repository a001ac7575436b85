#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_panel.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/page/thin_curve.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/widgets/dashed_curve.h"

namespace taxel::ui {

namespace {

/// Returns the plot's x for a time of the run: the travel [mm] in a sweep, otherwise the time [s]. NaN outside of the
/// run.
double x_at(const std::vector<TraceRow>& rows, bool sweep, double time) {
  if (rows.size() < 2 || time < rows.front().time || time > rows.back().time)
    return std::numeric_limits<double>::quiet_NaN();
  if (!sweep) return time;
  const auto next = std::upper_bound(rows.begin() + 1, rows.end() - 1, time,
                                     [](double t, const TraceRow& row) { return t < row.time; });
  const TraceRow &a = *(next - 1), &b = *next;
  const double part = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
  return 1e3 * ((1 - part) * a.travel + part * b.travel);
}

/// The conversion from a recorded value to the reading that the value stands for.
struct AsReading {
  double gain = 1, offset = 0;
  [[nodiscard]] double operator()(double value) const { return (value - offset) / gain; }
};

/// Returns the conversion of a taxel. Without a gain, the largest of all values is scaled to the largest reading.
AsReading as_reading(const RealShown& real, int taxel, double largest) {
  for (const TaxelFit& fit : real.fits)
    if (fit.taxel == taxel && fit.refused.empty()) return {fit.gain, fit.offset};
  double most = 0;
  for (const std::vector<double>& values : real.recording.series.values)
    for (const double value : values) most = std::max(most, std::isnan(value) ? 0.0 : std::abs(value));
  return {largest > 0 && most > 0 ? most / largest : 1, 0};
}

void rebuild(RealCurves& kept, const RunView& run, const RealState& real_state, double largest, std::size_t first) {
  const RealShown& real = *real_state.shown;
  const Trace& trace = *run.frame->trace;
  kept = {real_state.shown, trace.edition, trace.rows.size(), first, {}};
  const TaxelSeries& series = real.recording.series;
  for (std::size_t k = 0; k < series.taxel_ids.size(); ++k) {
    RealCurves::Curve& curve = kept.curves.emplace_back();
    curve.taxel = series.taxel_ids[k];
    const AsReading reading = as_reading(real, curve.taxel, largest);
    for (std::size_t i = 0; i < series.time.size(); ++i) {
      const double x = x_at(trace.rows, run.by_travel(), series.time[i] + real.shift);
      const double y = series.values[k][i];
      if (std::isnan(x) || std::isnan(y)) continue;
      curve.x.push_back(x);
      curve.y.push_back(reading(y));
    }
  }
}

void draw_dashed(const CurvePoints& curve, double scale, ImU32 color, float weight, double pixel_scale) {
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  constexpr DashLengths kLengths;
  const CurvePoints dashes = dashes_of(curve, pixels.x / limits.X.Size(), scale * pixels.y / limits.Y.Size(),
                                       {kLengths.dash * pixel_scale, kLengths.gap * pixel_scale});
  for (std::size_t i = 1; i < dashes.x.size(); ++i) {
    if (std::isnan(dashes.x[i - 1]) || std::isnan(dashes.x[i])) continue;
    ImPlot::GetPlotDrawList()->AddLine(ImPlot::PlotToPixels(dashes.x[i - 1], scale * dashes.y[i - 1]),
                                       ImPlot::PlotToPixels(dashes.x[i], scale * dashes.y[i]), color, weight);
  }
}

/// Returns whether the plot leaves the taxel out because it leaves out the taxel's reading.
bool is_left_out(const PlotState& plot, std::size_t reading) {
  if (!plot.options.responding_only || reading >= plot.curves.readings.size()) return false;
  return !(plot.curves.peaks[reading] > kTaxelResponds * plot.curves.largest);
}

}  // namespace

void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, std::size_t first) {
  if (!real.shown || !run.frame->trace || real.shown->sensor != selection.sensor) return;
  RealCurves& kept = real.curves;
  const Trace& trace = *run.frame->trace;
  if (kept.shown != real.shown || kept.edition != trace.edition || kept.rows != trace.rows.size() ||
      kept.first != first)
    rebuild(kept, run, real, largest, first);
  const SensorModel& model = *run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)];
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  CurvePoints drawn;
  ImPlot::PushPlotClipRect();
  for (const RealCurves::Curve& curve : kept.curves) {
    for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
      if (model.layout.taxels[k].id != curve.taxel || is_left_out(plot, first + k)) continue;
      const glm::vec3 c = taxel_color(model.color(static_cast<int>(k)));
      const float weight = (selection.contains(curve.taxel) ? 2.4f : 1.4f) * static_cast<float>(ui.pixel_scale);
      thin_curve(curve.x, curve.y, limits.X.Size() / std::max(1.0f, pixels.x),
                 kCurveTolerance * limits.Y.Size() / (scale * std::max(1.0f, pixels.y)), drawn);
      draw_dashed(drawn, scale, ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1)), weight, ui.pixel_scale);
    }
  }
  ImPlot::PopPlotClipRect();
}

}  // namespace taxel::ui
