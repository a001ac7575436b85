#include "app/studio/features/plot/plot_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/curve_colors.h"

namespace taxel::ui {

namespace {

constexpr double kPageWidth = 432, kPageHeight = 260;  // page without further columns of the legend [points]
constexpr double kPageLeft = 46, kPageTop = 12, kPageBottom = 36;               // margins around the axes [points]
constexpr double kPageRight = 12, kPageAxesWidth = 320;                         // [points]
constexpr double kPageText = 9, kPageRow = 12, kPageSwatch = 20, kPageGap = 6;  // texts and legend [points]
constexpr PageColor kPageBlack{0, 0, 0}, kPageWhite{1, 1, 1}, kPageGrid{0.87, 0.87, 0.87};

/// The axes on the page.
struct PageAxes {
  double x_end, y_end;
  [[nodiscard]] double x(double value) const { return kPageLeft + kPageAxesWidth * value / x_end; }
  [[nodiscard]] double y(double value) const {
    return kPageHeight - kPageBottom - (kPageHeight - kPageTop - kPageBottom) * std::clamp(value / y_end, 0.0, 1.0);
  }
};

PageColor page_color(int number, bool dimmed) {
  glm::vec3 c = curve_color_on(number, glm::vec3(1));
  if (dimmed) c = glm::mix(glm::vec3(1), c, kDimmedAlpha);
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

/// Returns a line in the style of a curve. Pixels of the window are 0.6 points.
PageLine styled_line(std::vector<PagePoint> points, const ChosenCurve& curve, const CurveStyle& style) {
  constexpr double kPointsPerPixel = 0.6;
  PageLine line{std::move(points), page_color(curve.color, style.dimmed), kPointsPerPixel * style.width, {}, 0};
  if (!style.dashes) return line;
  line.dashes = {kPointsPerPixel * style.dashes->dash, kPointsPerPixel * style.dashes->gap};
  line.dash_start = kPointsPerPixel * style.dashes->start;
  return line;
}

void add_axes(Page& page, const PageAxes& place, const PlotAxes& axes) {
  const double bottom = place.y(0), top = place.y(axes.y_end), right = place.x(axes.x_end);
  for (const double tick : round_ticks(axes.x_end, 8)) {
    page.items.push_back(PageLine{{{place.x(tick), bottom}, {place.x(tick), top}}, kPageGrid, 0.5, {}, 0});
    page.items.push_back(PageText{
        {place.x(tick), bottom + 11}, fmt::format("{:g}", tick), kPageText, kPageBlack, TextAnchor::middle, false});
  }
  for (const double tick : round_ticks(axes.y_end, 6)) {
    page.items.push_back(PageLine{{{kPageLeft, place.y(tick)}, {right, place.y(tick)}}, kPageGrid, 0.5, {}, 0});
    page.items.push_back(PageText{
        {kPageLeft - 4, place.y(tick) + 3}, fmt::format("{:g}", tick), kPageText, kPageBlack, TextAnchor::end, false});
  }
  page.items.push_back(PageText{
      {0.5 * (kPageLeft + right), bottom + 26}, axes.x_name, kPageText, kPageBlack, TextAnchor::middle, false});
  page.items.push_back(
      PageText{{12, 0.5 * (top + bottom)}, axes.y_name, kPageText, kPageBlack, TextAnchor::middle, true});
}

/// Adds the frame of the axes above the curves.
void add_frame(Page& page, const PageAxes& place, const PlotAxes& axes) {
  const double bottom = place.y(0), top = place.y(axes.y_end), right = place.x(axes.x_end);
  page.items.push_back(
      PageLine{{{kPageLeft, top}, {kPageLeft, bottom}, {right, bottom}, {right, top}, {kPageLeft, top}},
               kPageBlack,
               0.7,
               {},
               0});
}

std::size_t legend_rows() {
  return static_cast<std::size_t>((kPageHeight - kPageTop - kPageBottom) / kPageRow);
}

double legend_column(const PlotChoice& choice) {
  double widest = 0;
  for (const ChosenCurve& curve : choice.curves) widest = std::max(widest, kPageText * helvetica_width(curve.label));
  return kPageSwatch + 2 * kPageGap + widest;
}

void add_legend(Page& page, const PlotChoice& choice, const std::vector<TaxelKey>& focus) {
  const double column = legend_column(choice);
  for (std::size_t i = 0; i < choice.curves.size(); ++i) {
    const ChosenCurve& curve = choice.curves[i];
    const double x = kPageLeft + kPageAxesWidth + kPageRight + static_cast<double>(i / legend_rows()) * column;
    const double y = kPageTop + (static_cast<double>(i % legend_rows()) + 0.5) * kPageRow;
    page.items.push_back(styled_line({{x, y}, {x + kPageSwatch, y}}, curve, style_of(curve, focus)));
    page.items.push_back(
        PageText{{x + kPageSwatch + kPageGap, y + 3}, curve.label, kPageText, kPageBlack, TextAnchor::start, false});
  }
}

}  // namespace

PlotAxes plot_axes(const RunView& run, const PlotChoice& choice, bool relative) {
  const SimScene& scene = *run.frame->scene;
  constexpr double kAbove = 1.08;  // height of the axis, as a factor of the largest reading
  PlotAxes axes;
  axes.x_end = run.by_travel() ? 1e3 * scene.duration * run.scenario.as<scenarios::Sweep>().speed
                               : std::max(1.0, scene.duration > 0 ? scene.duration : run.frame->time);
  axes.y_end = kAbove * (relative || !(choice.largest > 0) ? 1.0 : choice.unit.scale * choice.largest);
  axes.x_name = run.by_travel() ? "travel (mm)" : "time (s)";
  axes.y_name = relative ? "reading / largest" : fmt::format("reading ({})", choice.unit.text);
  return axes;
}

std::vector<double> round_ticks(double end, int most) {
  std::vector<double> ticks;
  if (!(end > 0) || !std::isfinite(end)) return {0};
  const double least = end / most, power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= least * (1 - 1e-12)) step = factor * power;
  for (int i = 0; i <= most && i * step <= end * (1 + 1e-12); ++i) ticks.push_back(i * step);
  return ticks;
}

Page plot_page(PlotCurves& curves, const PlotChoice& choice, const std::vector<TaxelKey>& focus, const PlotAxes& axes,
               bool relative, const std::string& title) {
  constexpr double kResolution = 0.25, kTolerance = 0.05;  // of the curves [points]
  const std::size_t columns = std::max<std::size_t>(1, (choice.curves.size() + legend_rows() - 1) / legend_rows());
  Page page{std::max(kPageWidth, kPageLeft + kPageAxesWidth + kPageRight +
                                     static_cast<double>(columns) * legend_column(choice) + kPageGap),
            kPageHeight,
            title,
            {}};
  page.items.push_back(PageRect{{0, 0}, {page.width, page.height}, kPageWhite});
  const PageAxes place{axes.x_end, axes.y_end};
  add_axes(page, place, axes);
  const double column = kResolution * axes.x_end / kPageAxesWidth,
               tolerance = kTolerance * axes.y_end / (kPageHeight - kPageTop - kPageBottom);
  for (const std::size_t i : drawing_order(choice.curves, focus)) {
    const ChosenCurve& curve = choice.curves[i];
    const CurvePoints& drawn = drawn_curve(curves, curve.reading, column, tolerance, plot_scale(choice, relative));
    std::vector<PagePoint> points;
    for (std::size_t p = 0; p < drawn.x.size() && drawn.x[p] <= axes.x_end; ++p)
      points.push_back({place.x(drawn.x[p]), place.y(drawn.y[p])});
    page.items.push_back(styled_line(std::move(points), curve, style_of(curve, focus)));
  }
  add_frame(page, place, axes);
  add_legend(page, choice, focus);
  return page;
}

std::optional<Page> displayed_plot(const RunView& run, const Selection& selection, PlotState& plot,
                                   const std::string& title) {
  const std::vector<SensorShown> sensors = sensors_shown(run);
  if (sensors.empty() || !run.frame->trace || run.frame->trace->rows.empty()) return std::nullopt;
  update_curves(plot.curves, *run.frame->trace, run.by_travel());
  const PlotChoice choice = choose_curves(plot.curves, sensors, selection, plot.options, stopped_taxel(run, sensors));
  return plot_page(plot.curves, choice, focus_of(choice.curves, std::nullopt, plot.isolated),
                   plot_axes(run, choice, plot.options.relative), plot.options.relative, title);
}

}  // namespace taxel::ui
