#include "core/base/page/chart_page.h"

#include <algorithm>
#include <cmath>

#include "core/base/page/chart_layout.h"
#include "core/base/page/clip_curve.h"
#include "core/base/page/viridis.h"

namespace taxel {
namespace {

constexpr PageColor kChartBlack{0, 0, 0}, kChartWhite{1, 1, 1}, kChartGrid{0.87, 0.87, 0.87};
constexpr int kCellColors = 64;  // number of colours of cells; more look alike

/// Returns the colour of a fraction of the scale, one of kCellColors.
PageColor cell_color(int level) {
  const Rgb8 c = kViridis[(255 * level + (kCellColors - 1) / 2) / (kCellColors - 1)];
  return {c.r / 255.0, c.g / 255.0, c.b / 255.0};
}

template <class Values>
int cell_level(const Values& cells, double value) {
  const double t = (value - cells.low) / (cells.high - cells.low);
  return t > 0 ? static_cast<int>(std::lround((kCellColors - 1) * std::min(t, 1.0))) : 0;  // NaN becomes 0
}

/// Draws the panels of one chart.
class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, const ChartLayout& layout)
      : chart_(chart), layout_(layout), page_{layout.width, layout.height, chart.title, {}} {}

  Page page() {
    page_.items.emplace_back(PageRect{{0, 0}, {layout_.width, layout_.height}, kChartWhite});
    if (!chart_.heading.empty()) add_text({0.5 * layout_.width, 17}, chart_.heading, TextAnchor::middle, false, 11);
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) add_panel(chart_.panels[i], layout_.panels[i]);
    return std::move(page_);
  }

 private:
  void add_line(std::vector<PagePoint> points, const PageColor& color, double width) {
    page_.items.emplace_back(PageLine{std::move(points), color, width, {}, 0});
  }
  void add_text(PagePoint at, const std::string& text, TextAnchor anchor, bool upward = false,
                double size = kChartText) {
    page_.items.emplace_back(PageText{at, text, size, kChartBlack, anchor, upward});
  }

  void add_panel(const ChartPanel& panel, const PanelPlace& place) {
    add_x_axis(panel, place);
    if (panel.cells)
      add_cells(panel, place);
    else
      add_y_axis(panel, place);
    if (panel.dots) add_dots(panel, place);
    for (const ChartCurve& curve : panel.curves) add_curve(panel, place, curve);
    add_line({{place.left, place.top},
              {place.left, place.bottom},
              {place.right, place.bottom},
              {place.right, place.top},
              {place.left, place.top}},
             kChartBlack, 0.7);
    if (!panel.title.empty())
      add_text({0.5 * (place.left + place.right), place.top - 6}, panel.title, TextAnchor::middle);
    add_legend(panel, place);
  }

  void add_x_axis(const ChartPanel& panel, const PanelPlace& place) {
    const std::vector<std::string> texts = tick_texts(place.x_ticks);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const double x = place.x(panel.x, place.x_ticks.values[i]);
      if (!panel.cells) add_line({{x, place.bottom}, {x, place.top}}, kChartGrid, 0.5);
      if (panel.cells) add_line({{x, place.bottom}, {x, place.bottom + 3}}, kChartBlack, 0.7);
      if (panel.x.has_texts) add_text({x, place.bottom + 11}, texts[i], TextAnchor::middle);
    }
    if (panel.x.has_texts)
      add_text({0.5 * (place.left + place.right), place.bottom + 26}, panel.x.name, TextAnchor::middle);
  }

  void add_y_axis(const ChartPanel& panel, const PanelPlace& place) {
    const std::vector<std::string> texts = tick_texts(place.y_ticks);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const double y = place.y(panel.y, place.y_ticks.values[i]);
      add_line({{place.left, y}, {place.right, y}}, kChartGrid, 0.5);
      if (panel.y.has_texts) add_text({place.left - 4, y + 3}, texts[i], TextAnchor::end);
    }
    if (panel.y.low < 0 && panel.y.high > 0)
      add_line({{place.left, place.y(panel.y, 0)}, {place.right, place.y(panel.y, 0)}}, {0.5, 0.5, 0.5}, 0.7);
    if (panel.y.has_texts) add_y_name(panel, place);
  }

  void add_y_name(const ChartPanel& panel, const PanelPlace& place) {
    add_text({place.outer_left + 12, 0.5 * (place.top + place.bottom)}, panel.y.name, TextAnchor::middle, true);
  }

  void add_curve(const ChartPanel& panel, const PanelPlace& place, const ChartCurve& curve) {
    constexpr double kResolution = 0.25, kTolerance = 0.05;  // [points]
    const double column = kResolution * (panel.x.high - panel.x.low) / (place.right - place.left),
                 tolerance = kTolerance * (panel.y.high - panel.y.low) / (place.bottom - place.top);
    CurvePoints thin = thin_path(curve.points.x, curve.points.y, column, tolerance);
    thin = clip_curve(thin, {panel.x.low, panel.x.high, panel.y.low, panel.y.high});
    if (thin.x.size() == 1) return add_dot(panel, place, thin, curve.style);
    std::vector<PagePoint> points;
    for (std::size_t i = 0; i < thin.x.size(); ++i)
      points.push_back({place.x(panel.x, thin.x[i]), place.y(panel.y, thin.y[i])});
    page_.items.emplace_back(
        PageLine{points, curve.style.color, curve.style.width, curve.style.dashes, curve.style.dash_start});
  }

  /// Draws a curve of one point, which has no line, as a square.
  void add_dot(const ChartPanel& panel, const PanelPlace& place, const CurvePoints& point, const LineStyle& style) {
    constexpr double kHalf = 2;  // [points]
    const double x = place.x(panel.x, point.x[0]), y = place.y(panel.y, point.y[0]);
    page_.items.emplace_back(PageRect{{x - kHalf, y - kHalf}, {x + kHalf, y + kHalf}, style.color});
  }

  /// Draws neighbours of the same colour as one rectangle. Each rectangle reaches under its right and lower neighbours,
  /// so that no white lines are between them.
  void add_cells(const ChartPanel& panel, const PanelPlace& place) {
    constexpr double kUnder = 0.4;  // [points]
    const ChartCells& cells = *panel.cells;
    const double height = (place.bottom - place.top) / static_cast<double>(std::max<std::size_t>(1, cells.rows.size()));
    page_.items.emplace_back(PageRect{{place.left, place.top}, {place.right, place.bottom}, cell_color(0)});
    for (std::size_t row = 0; row < cells.rows.size(); ++row) {
      const double top = place.top + static_cast<double>(row) * height;
      const std::vector<double>& values = cells.values[row];
      for (std::size_t first = 0, end = 0; first < values.size(); first = end) {
        const int level = cell_level(cells, values[first]);
        for (end = first + 1; end < values.size() && cell_level(cells, values[end]) == level;) ++end;
        if (level == 0 && row == 0 && first == 0) continue;  // the background has this colour
        const double right = place.x(panel.x, cells.edges[end]) + kUnder, bottom = top + height + kUnder;
        page_.items.emplace_back(PageRect{{place.x(panel.x, cells.edges[first]), top},
                                          {std::min(right, place.right), std::min(bottom, place.bottom)},
                                          cell_color(level)});
      }
      if (row % place.row_step == 0)
        add_text({place.left - 4, top + 0.5 * height + 3}, cells.rows[row], TextAnchor::end);
    }
    add_y_name(panel, place);
    add_color_bar({cells.low, cells.high, cells.name, true}, place);
  }

  void add_dots(const ChartPanel& panel, const PanelPlace& place) {
    constexpr double kHalf = 0.7;  // half the side of a square [points]
    const ChartDots& dots = *panel.dots;
    for (std::size_t i = 0; i < dots.x.size(); ++i) {
      const double x = place.x(panel.x, dots.x[i]), y = place.y(panel.y, dots.y[i]);
      page_.items.emplace_back(
          PageRect{{x - kHalf, y - kHalf}, {x + kHalf, y + kHalf}, cell_color(cell_level(dots, dots.values[i]))});
    }
    add_color_bar({dots.low, dots.high, dots.name, true}, place);
  }

  void add_color_bar(const ChartAxis& scale, const PanelPlace& place) {
    const double left = place.right + 8, height = place.bottom - place.top;
    for (int level = 0; level < kCellColors; ++level)  // each colour covers the upper part of the one before
      page_.items.emplace_back(PageRect{
          {left, place.bottom - height * level / kCellColors}, {left + kColorBar, place.top}, cell_color(level)});
    AxisTicks ticks = axis_ticks(scale.low, scale.high, std::max(2, static_cast<int>(height / 35)));
    const std::vector<std::string> texts = tick_texts(ticks);
    double widest = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const double y = place.y(scale, ticks.values[i]);
      add_line({{left + kColorBar, y}, {left + kColorBar + 2, y}}, kChartBlack, 0.7);
      add_text({left + kColorBar + 4, y + 3}, texts[i], TextAnchor::start);
      widest = std::max(widest, kChartText * helvetica_width(texts[i]));
    }
    add_text({left + kColorBar + 4 + widest + 12, 0.5 * (place.top + place.bottom)}, scale.name, TextAnchor::middle,
             true);
  }

  void add_swatch(PagePoint at, const LineStyle& style) {
    page_.items.emplace_back(
        PageLine{{at, {at.x + kLegendSwatch, at.y}}, style.color, style.width, style.dashes, style.dash_start});
  }

  void add_legend(const ChartPanel& panel, const PanelPlace& place) {
    const bool is_cut = place.legend_entries < panel.legend.size();
    for (std::size_t i = 0; i < place.legend_entries; ++i) {
      const PagePoint corner = place.legend_at(i);
      const double y = corner.y + 0.5 * kLegendRow;
      if (is_cut && i + 1 == place.legend_entries) {
        add_text({corner.x, y + 3}, more_entries(panel.legend.size() - i), TextAnchor::start);
        continue;
      }
      const LegendEntry& entry = panel.legend[i];
      if (entry.below) add_swatch({corner.x, y}, *entry.below);
      add_swatch({corner.x, y}, entry.style);
      add_text({corner.x + kLegendSwatch + kLegendGap, y + 3}, entry.label, TextAnchor::start);
    }
  }

  const Chart& chart_;
  const ChartLayout& layout_;
  Page page_;
};

}  // namespace

Page chart_page(const Chart& chart) {
  return ChartDrawing(chart, lay_out_chart(chart)).page();
}

}  // namespace taxel
