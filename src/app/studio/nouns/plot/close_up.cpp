#include "app/studio/nouns/plot/close_up.h"

#include <implot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/theme.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

StepRange close_up_steps(const HistoryLanes& lanes, const PlotCloseUp& close_up) {
  const std::uint64_t first = lanes.steps.front().step, last = lanes.steps[lanes.rows() - 1].step;
  const std::uint64_t middle = std::clamp(close_up.step, first, last);
  return {middle - std::min(middle - first, kCloseUpSteps), middle + std::min(last - middle, kCloseUpSteps)};
}

std::optional<std::size_t> reading_index(const std::vector<SensorShown>& sensors, const TaxelKey& key) {
  for (const SensorShown& sensor : sensors) {
    if (sensor.index != key.sensor) continue;
    for (std::size_t k = 0; k < sensor.taxels().size(); ++k)
      if (sensor.taxels()[k].id == key.id) return sensor.first + k;
  }
  return std::nullopt;
}

StepCurve recorded_curve(const HistoryLanes& lanes, std::size_t reading, StepRange steps, bool by_travel) {
  StepCurve curve;
  if (reading >= lanes.reading_count || lanes.rows() == 0) return curve;
  for (std::size_t row = lanes.row_of(steps.first); row <= lanes.row_of(steps.last); ++row) {
    const StepMark& mark = lanes.steps[row];
    curve.x.push_back(by_travel ? 1e3 * mark.travel : mark.time);
    curve.readings.push_back(lanes.readings_of(row)[reading]);
  }
  return curve;
}

EarlierCurvePtr readings_before(const RunView& run, const TaxelKey& key, const Layout& after) {
  const HistoryLanes* lanes = run.frame ? run.frame->history.lanes.get() : nullptr;
  const std::optional<std::size_t> reading = reading_index(sensors_shown(run), key);
  if (lanes == nullptr || lanes->rows() == 0 || !reading) return nullptr;
  const StepRange all{lanes->steps.front().step, lanes->steps[lanes->rows() - 1].step};
  return std::make_shared<const EarlierCurve>(
      EarlierCurve{key, run.by_travel(), recorded_curve(*lanes, *reading, all, run.by_travel()), after});
}

double CloseUpView::change_height(double plot_height) const {
  return plot_height * std::abs(to - from) / (bounds.y_high - bounds.y_low);
}

namespace {

/// Returns the part of a curve between two x, with its readings times `scale`.
CurvePoints part_of(const StepCurve& curve, double from, double to, double scale) {
  CurvePoints part;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] < from || curve.x[i] > to) continue;
    part.x.push_back(curve.x[i]);
    part.y.push_back(scale * curve.readings[i]);
  }
  return part;
}

/// Sets the vertical ends of a view, see view_close_up().
void fit_height(CloseUpView& view, double plot_height) {
  constexpr double kRoom = 0.08;  // above and below the curves, as a fraction of their height
  double low = std::min(view.from, view.to), high = std::max(view.from, view.to);
  double change = high - low;
  // After a remedy the former step is the larger one, and both are to be compared.
  const std::vector<double>& before = view.before.y;
  for (std::size_t i = 1; i < before.size(); ++i) change = std::max(change, std::abs(before[i] - before[i - 1]));
  for (const CurvePoints* curve : {&view.readings, &view.exact, &view.before})
    for (const double y : curve->y)
      if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
  const double room = high > low ? kRoom * (high - low) : std::max(1e-3 * std::abs(high), 1e-9);
  low -= room, high += room;
  const double most = change * std::max(1 + 2 * kRoom, plot_height / kChangeHeight);  // in a low plot all of the change
  if (change > 0 && high - low > most) {
    const double middle = std::clamp(0.5 * (view.from + view.to), low + 0.5 * most, high - 0.5 * most);
    low = middle - 0.5 * most, high = middle + 0.5 * most;
  }
  view.bounds.y_low = low, view.bounds.y_high = high;
}

}  // namespace

std::optional<CloseUpView> view_close_up(const RunView& run, const std::vector<SensorShown>& sensors,
                                         const PlotCloseUp& close_up, const ExactCurvePtr& exact,
                                         const EarlierCurvePtr& before, double scale, double plot_height) {
  const HistoryLanes* lanes = run.frame->history.lanes.get();
  const std::optional<std::size_t> reading = reading_index(sensors, close_up.key);
  if (lanes == nullptr || !reading || lanes->rows() < 2 || *reading >= lanes->reading_count ||
      close_up.step <= lanes->steps.front().step || close_up.step > lanes->steps[lanes->rows() - 1].step)
    return std::nullopt;
  const bool by_travel = run.by_travel();
  const StepCurve recorded = recorded_curve(*lanes, *reading, close_up_steps(*lanes, close_up), by_travel);
  CloseUpView view;
  view.bounds.x_low = recorded.x.front(), view.bounds.x_high = recorded.x.back();
  if (!(view.bounds.x_high > view.bounds.x_low)) return std::nullopt;  // the object of a sweep waits
  const auto visible = [&](const StepCurve& curve) {
    return part_of(curve, view.bounds.x_low, view.bounds.x_high, scale);
  };
  view.readings = visible(recorded);
  const bool is_read = exact && exact->of == close_up && exact->scene == run.frame->scene;
  if (is_read && exact->by_travel == by_travel) view.exact = visible(exact->curve);
  if (before && before->key == close_up.key && before->by_travel == by_travel) view.before = visible(before->curve);
  const StepCurve change = recorded_curve(*lanes, *reading, {close_up.step - 1, close_up.step}, by_travel);
  view.from = scale * change.readings.front(), view.to = scale * change.readings.back();
  view.x_from = change.x.front(), view.x_to = change.x.back();
  fit_height(view, plot_height);
  return view;
}

namespace {

constexpr float kExactWidth = 4, kReadingWidth = 2, kChangeWidth = 3.5f;  // [pixels at scale 1]

void plot_points(const char* id, const CurvePoints& points, const ImVec4& color, float width) {
  ImPlotSpec spec;
  spec.LineColor = color;
  spec.LineWeight = width;
  ImPlot::PlotLine(id, points.x.data(), points.y.data(), static_cast<int>(points.x.size()), spec);
}

/// Draws a curve as dashes.
void plot_dashes(const WindowUi& ui, const char* id, const CurvePoints& points, const ImVec4& color) {
  constexpr double kDash = 5;  // [pixels at scale 1]
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  const double dash = kDash * ui.pixel_scale;
  const CurvePoints dashes = dashes_of(points, pixels.x / limits.X.Size(), pixels.y / limits.Y.Size(), {dash, dash, 0});
  plot_points(id, dashes, color, kReadingWidth * static_cast<float>(ui.pixel_scale));
}

/// The colour of the exact integral: that of text, which is no taxel's and not the cursor's, paler.
ImVec4 exact_color(const WindowUi& ui) {
  constexpr float kBehind = 0.5f;
  const ImVec4& text = palette(ui.dark).text;
  return {text.x, text.y, text.z, kBehind};
}

/// The colour of readings before a remedy: that of the taxel, paler.
ImVec4 earlier_color(const ImVec4& color) {
  constexpr float kPale = 0.75f;
  return {color.x, color.y, color.z, kPale};
}

/// Draws the key of the curves at a corner of the plot that no curve crosses, as far as there is one.
void draw_close_up_key(const WindowUi& ui, const CloseUpView& view, const ImVec4& color, const std::string& problem) {
  const Palette& colors = palette(ui.dark);
  struct Entry {
    const char* text;
    ImVec4 color;
    bool dashed = false;
  };
  std::vector<Entry> entries{{"reading", color}};
  if (!view.exact.x.empty()) entries.push_back({"exact integral", exact_color(ui)});
  if (!view.before.x.empty()) entries.push_back({"before", earlier_color(color), true});
  const float line = ImGui::GetFontSize(), swatch = 1.6f * line, row = 1.15f * line;
  float widest = problem.empty() ? 0.0f : ImGui::CalcTextSize(problem.c_str()).x;
  for (const Entry& entry : entries) widest = std::max(widest, ImGui::CalcTextSize(entry.text).x);
  const ImVec2 corner = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize();
  const float x = view.to < view.from ? corner.x + size.x - widest - swatch - 1.2f * line : corner.x + 0.5f * line;
  float y = corner.y + 0.3f * line;
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  const auto rows = static_cast<float>(entries.size() + (problem.empty() ? 0 : 1));
  list.AddRectFilled({x - 0.3f * line, y - 0.1f * line}, {x + swatch + 0.7f * line + widest, y + rows * row},
                     to_u32(colors.raised, 0.85f), 3);
  for (const Entry& entry : entries) {
    const float middle = std::round(y + 0.5f * line);
    const float part = entry.dashed ? 0.4f * swatch : swatch;
    list.AddLine({x, middle}, {x + part, middle}, to_u32(entry.color), 2.5f);
    if (entry.dashed) list.AddLine({x + swatch - part, middle}, {x + swatch, middle}, to_u32(entry.color), 2.5f);
    list.AddText({x + swatch + 0.4f * line, y}, to_u32(colors.text), entry.text);
    y += row;
  }
  if (!problem.empty()) list.AddText({x, y}, to_u32(colors.dim), problem.c_str());
}

}  // namespace

void draw_behind_close_up(const WindowUi& ui, const CloseUpView& view, const ImVec4& color) {
  const auto pixel = static_cast<float>(ui.pixel_scale);
  if (!view.exact.x.empty()) plot_points("##exact", view.exact, exact_color(ui), kExactWidth * pixel);
  if (!view.before.x.empty()) plot_dashes(ui, "##before", view.before, earlier_color(color));
}

void draw_close_up(const WindowUi& ui, const CloseUpView& view, const ImVec4& color, const std::string& problem) {
  const auto pixel = static_cast<float>(ui.pixel_scale);
  plot_points("##steps", view.readings, color, kReadingWidth * pixel);
  const CurvePoints change{{view.x_from, view.x_to}, {view.from, view.to}};
  plot_points("##change", change, palette(ui.dark).text, kChangeWidth * pixel);
  ImPlot::PushPlotClipRect();
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  for (std::size_t i = 0; i < view.readings.x.size(); ++i)
    list.AddCircleFilled(ImPlot::PlotToPixels(view.readings.x[i], view.readings.y[i]), 2.2f * pixel, to_u32(color));
  draw_close_up_key(ui, view, color, problem);
  ImPlot::PopPlotClipRect();
}

void draw_earlier_curve(const WindowUi& ui, const EarlierCurve& before, const ImVec4& color, double scale) {
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  CurvePoints thin;
  thin_curve(before.curve.x, before.curve.readings, limits.X.Size() / std::max(1.0f, pixels.x),
             kCurveTolerance * limits.Y.Size() / (std::max(1.0f, pixels.y) * scale), thin);
  for (double& y : thin.y) y *= scale;
  plot_dashes(ui, "##before", thin, earlier_color(color));
}

}  // namespace taxel::ui
