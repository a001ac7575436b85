#include "app/studio/nouns/plot/plot_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/page/chart_page.h"
#include "ui/curve_colors.h"

namespace taxel::ui {

namespace {

constexpr double kPageWidth = 432;  // smallest width of the page [points]

PageColor page_color(int number, bool dimmed) {
  glm::vec3 c = curve_color_on(number, glm::vec3(1));
  if (dimmed) c = glm::mix(glm::vec3(1), c, kDimmedAlpha);
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

/// Returns the look of a curve on paper. Pixels of the window are 0.6 points.
LineStyle paper_style(const ChosenCurve& curve, const CurveStyle& style) {
  constexpr double kPointsPerPixel = 0.6;
  LineStyle line{page_color(curve.color, style.dimmed), kPointsPerPixel * style.width, {}, 0};
  if (!style.dashes) return line;
  line.dashes = {kPointsPerPixel * style.dashes->dash, kPointsPerPixel * style.dashes->gap};
  line.dash_start = kPointsPerPixel * style.dashes->start;
  return line;
}

}  // namespace

PlotAxes plot_axes(const RunView& run, const PlotChoice& choice, bool relative) {
  const SimScene& scene = *run.frame->scene;
  constexpr double kAbove = 1.08;  // height of the axis, as a factor of the largest reading
  PlotAxes axes;
  axes.x_end = run.by_travel() ? 1e3 * scene.duration * run.scenario.as<scenarios::Sweep>().speed
                               : std::max(1.0, scene.duration > 0 ? scene.duration : run.frame->time);
  const double largest = choice.quantity == PlotQuantity::slip ? 1.0 : choice.largest;  // slip ends at 100 %
  axes.y_end = kAbove * (relative || !(largest > 0) ? 1.0 : choice.unit.scale * largest);
  axes.x_name = run.by_travel() ? "travel (mm)" : "time (s)";
  const char* name = words_of(choice.quantity).axis;
  axes.y_name = relative ? fmt::format("{} / largest", name) : fmt::format("{} ({})", name, choice.unit.text);
  return axes;
}

Page plot_page(PlotCurves& curves, const PlotChoice& choice, const std::vector<TaxelKey>& focus, const PlotAxes& axes,
               bool relative, const std::string& title) {
  ChartPanel panel;
  panel.x = {0, axes.x_end, axes.x_name, true};
  panel.y = {0, axes.y_end, axes.y_name, true};
  const double scale = plot_scale(choice, relative);
  for (const std::size_t i : drawing_order(choice.curves, focus)) {
    const ChosenCurve& curve = choice.curves[i];
    ChartCurve drawn{{curves.x, curves.readings[curve.reading]}, paper_style(curve, style_of(curve, focus))};
    for (double& y : drawn.points.y) y = std::max(0.0, scale * y);
    panel.curves.push_back(std::move(drawn));
  }
  for (const ChosenCurve& curve : choice.curves)
    panel.legend.push_back({curve.label, paper_style(curve, style_of(curve, focus))});
  Chart chart;
  chart.title = title;
  chart.min_width = kPageWidth;
  chart.panels.push_back(std::move(panel));
  return chart_page(chart);
}

std::optional<Page> displayed_plot(const RunView& run, const Selection& selection, PlotState& plot,
                                   const std::string& title) {
  const std::vector<SensorShown> sensors = sensors_shown(run);
  if (sensors.empty() || !run.frame->trace || run.frame->trace->rows.empty()) return std::nullopt;
  update_curves(plot.curves, *run.frame->trace, run.by_travel(), available_quantity(sensors, plot.quantity));
  const PlotChoice choice = choose_curves(plot.curves, sensors, selection, plot.options, stopped_taxel(run, sensors));
  return plot_page(plot.curves, choice, focus_of(choice.curves, std::nullopt, plot.isolated),
                   plot_axes(run, choice, choice.relative), choice.relative, title);
}

}  // namespace taxel::ui
