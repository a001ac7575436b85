// The curves of a recording of a real sensor over the plot, in the window and on a page.
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/page/curve.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"

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

/// The conversion from a recorded value to the reading that gave it.
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

/// Draws the samples of a recording as rings, as far as they are apart on the screen. Returns their number.
int draw_points(const RealCurves::Curve& curve, double scale, ImU32 color, float weight, float pixel) {
  constexpr float kApart = 7, kRadius = 2.6f;  // [pixels at scale 1]
  ImVec2 last(-1e9f, 0);
  int drawn = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const ImVec2 at = ImPlot::PlotToPixels(curve.x[i], scale * curve.y[i]);
    if (std::hypot(at.x - last.x, at.y - last.y) < kApart * pixel) continue;
    ImPlot::GetPlotDrawList()->AddCircle(at, kRadius * pixel, color, 0, weight);
    last = at;
    ++drawn;
  }
  return drawn;
}

/// Names the look of a recording in the upper left corner of the plot.
void draw_points_key(const WindowUi& ui) {
  constexpr const char* kText = "real recording";
  const float line = ImGui::GetFontSize();
  const auto pixel = static_cast<float>(ui.pixel_scale);
  const Palette& colors = palette(ui.dark);
  const ImVec2 at(ImPlot::GetPlotPos().x + 0.5f * line, ImPlot::GetPlotPos().y + 0.3f * line);
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  const float text = 1.3f * line;
  list.AddRectFilled(at, {at.x + text + ImGui::CalcTextSize(kText).x + 0.3f * line, at.y + 1.2f * line},
                     to_u32(colors.raised, 0.85f), 3);
  list.AddCircle({at.x + 0.7f * line, at.y + 0.6f * line}, 2.6f * pixel, to_u32(colors.text), 0, 1.4f * pixel);
  list.AddText({at.x + text, at.y + 0.1f * line}, to_u32(colors.text), kText);
}

/// Returns whether the plot leaves the taxel out because it leaves out the taxel's reading.
bool is_left_out(const PlotState& plot, std::size_t reading) {
  if (!plot.options.responding_only || reading >= plot.curves.readings.size()) return false;
  return !(plot.curves.peaks[reading] > kTaxelResponds * plot.curves.largest);
}

/// A curve of the recording that the plot shows, and the index of its taxel in the layout.
struct ShownCurve {
  const RealCurves::Curve* curve = nullptr;
  int taxel = 0;
};

/// Returns the curves of the recording that belong to the plot of the selected sensor, built again if the recording or
/// the run has changed.
std::vector<ShownCurve> shown_curves(const Selection& selection, const RunView& run, RealState& real,
                                     const PlotState& plot, double largest, const std::vector<SensorShown>& sensors) {
  if (!real.shown || !run.frame->trace || real.shown->sensor != selection.sensor) return {};
  const auto sensor = std::ranges::find(sensors, selection.sensor, &SensorShown::index);
  if (sensor == sensors.end()) return {};
  RealCurves& kept = real.curves;
  const Trace& trace = *run.frame->trace;
  if (kept.shown != real.shown || kept.edition != trace.edition || kept.rows != trace.rows.size() ||
      kept.first != sensor->first)
    rebuild(kept, run, real, largest, sensor->first);
  std::vector<ShownCurve> shown;
  for (const RealCurves::Curve& curve : kept.curves) {
    const int taxel = index_of(sensor->model->layout, curve.taxel);
    if (taxel >= 0 && !is_left_out(plot, sensor->first + static_cast<std::size_t>(taxel)))
      shown.push_back({&curve, taxel});
  }
  return shown;
}

}  // namespace

void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, const std::vector<SensorShown>& sensors) {
  if (!real.shown || real.shown->sensor != selection.sensor) return;
  const std::vector<ShownCurve> curves = shown_curves(selection, run, real, plot, largest, sensors);
  const auto pixel = static_cast<float>(ui.pixel_scale);
  const SensorModel& model = *run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)];
  real.points = 0;
  ImPlot::PushPlotClipRect();
  for (const ShownCurve& shown : curves) {
    const glm::vec3 c = taxel_color(model.color(shown.taxel));
    const float weight = (selection.contains(shown.curve->taxel) ? 2.4f : 1.4f) * pixel;
    real.points += draw_points(*shown.curve, scale, ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1)), weight, pixel);
  }
  draw_points_key(ui);
  ImPlot::PopPlotClipRect();
}

std::vector<ChartRings> real_rings(const Selection& selection, const RunView& run, RealState& real,
                                   const PlotState& plot, const PlotChoice& choice,
                                   const std::vector<SensorShown>& sensors) {
  std::vector<ChartRings> rings;
  if (choice.quantity != PlotQuantity::reading) return rings;
  const double scale = plot_scale(choice, choice.relative);
  for (const ShownCurve& shown : shown_curves(selection, run, real, plot, choice.largest, sensors)) {
    const SensorModel& model = *run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)];
    rings.push_back({{shown.curve->x, shown.curve->y}, page_color(model.color(shown.taxel), false)});
    for (double& y : rings.back().points.y) y *= scale;
  }
  return rings;
}

void part_twins(std::vector<ChosenCurve>& curves, const RealState& real) {
  if (!real.shown) return;
  const TaxelSeries& series = real.shown->recording.series;
  const auto recorded = [&](const TaxelKey& key) -> std::span<const double> {
    const auto found = std::ranges::find(series.taxel_ids, key.id);
    if (key.sensor != real.shown->sensor || found == series.taxel_ids.end()) return {};
    return series.values[static_cast<std::size_t>(found - series.taxel_ids.begin())];
  };
  for (ChosenCurve& curve : curves) {
    if (curve.twin < 0) continue;
    const std::span<const double> first = recorded(curves[static_cast<std::size_t>(curve.twin)].key),
                                  second = recorded(curve.key);
    const bool has_any = !first.empty() || !second.empty();
    if (has_any && (first.size() != second.size() || !are_equal_curves(first, second))) curve.twin = -1;
  }
}

}  // namespace taxel::ui
