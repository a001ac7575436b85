// Ticks, the layout of charts, and their drawing.

#include "core/base/page/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/page/curve.h"
#include "core/base/page/viridis.h"

namespace taxel {
namespace {

constexpr int kMaxFiner = 12;  // largest number of steps that is tried to get two ticks

}  // namespace

AxisTicks axis_ticks(double low, double high, int most) {
  const double span = high - low, least = span / std::max(1, most);
  if (!(span > 0) || !std::isfinite(span) || !(least > 0)) return {{low}, 0};
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= least * (1 - 1e-12)) step = factor * power;
  if (!(step > 0)) return {{low}, 0};
  AxisTicks ticks{{}, step};
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  if (last - first < 1 && most < kMaxFiner) return axis_ticks(low, high, most + 1);
  for (double i = first; i <= last && ticks.values.size() <= static_cast<std::size_t>(std::max(1, most)); ++i)
    ticks.values.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

std::vector<std::string> tick_texts(const AxisTicks& ticks) {
  double largest = 0;
  for (const double value : ticks.values) largest = std::max(largest, std::abs(value));
  const bool has_power = largest >= 1e7 || (largest > 0 && largest < 1e-4);
  const double decimals = ticks.step > 0 ? std::max(0.0, -std::floor(std::log10(ticks.step) + 1e-9)) : 0;
  std::vector<std::string> texts;
  for (const double value : ticks.values)
    texts.push_back(has_power || !(ticks.step > 0) ? fmt::format("{:g}", value)
                                                   : fmt::format("{:.{}f}", value, static_cast<int>(decimals)));
  return texts;
}

namespace {

constexpr double kLeft = 46, kTop = 12, kRight = 12, kEdge = 6;  // smallest margins around axes, and of the page
constexpr double kTexts = 36, kNoTexts = 10;                     // below axes, with and without the texts of an axis
constexpr double kTitle = 14, kHeading = 20;                     // heights of titles
constexpr double kXTick = 40, kYTick = 35;                       // smallest distance of two ticks

double widest_text(const std::vector<std::string>& texts) {
  double widest = 0;
  for (const std::string& text : texts) widest = std::max(widest, kChartText * helvetica_width(text));
  return widest;
}

/// Returns ticks along `length` points whose texts do not touch each other if they are next to each other.
AxisTicks ticks_along(const ChartAxis& axis, double length, double distance, bool is_across) {
  for (int most = std::max(2, static_cast<int>(length / distance));; --most) {
    AxisTicks ticks = axis_ticks(axis.low, axis.high, most);
    const double gap = ticks.step * length / (axis.high - axis.low);
    if (most <= 1 || !is_across || ticks.values.size() < 2 || widest_text(tick_texts(ticks)) + 8 <= gap) return ticks;
  }
}

/// Computes the layout: heights first, because the columns of legends depend on them, then widths.
class ChartMeasure {
 public:
  explicit ChartMeasure(const Chart& chart)
      : chart_(chart), columns_(std::max<std::size_t>(1, chart.columns)), layout_{0, 0, {}} {
    layout_.panels.resize(chart.panels.size());
    rows_ = std::max<std::size_t>(1, (chart.panels.size() + columns_ - 1) / columns_);
  }

  ChartLayout layout() {
    measure_heights();
    measure_widths();
    for (std::size_t i = 0; i < chart_.panels.size(); ++i)
      layout_.panels[i].x_ticks = ticks_along(chart_.panels[i].x, axes_.x, kXTick, true);
    return std::move(layout_);
  }

 private:
  [[nodiscard]] const ChartPanel* panel(std::size_t row, std::size_t column) const {
    const std::size_t i = row * columns_ + column;
    return i < chart_.panels.size() ? &chart_.panels[i] : nullptr;
  }
  /// Returns true if the texts of the axis x are below a panel: also above an empty place of the grid.
  [[nodiscard]] bool has_x_texts(std::size_t row, std::size_t column) const {
    return panel(row, column) != nullptr && panel(row, column)->x.has_texts;
  }

  void measure_heights() {
    std::vector<double> above(rows_, kTop), below(rows_, kNoTexts);
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t column = 0; column < columns_; ++column) {
        const ChartPanel* one = panel(row, column);
        if (one != nullptr && !one->title.empty()) above[row] = kTop + kTitle;
        if (has_x_texts(row, column)) below[row] = kTexts;
      }
    double margins = chart_.heading.empty() ? 0 : kHeading;
    for (std::size_t row = 0; row < rows_; ++row) margins += above[row] + below[row];
    const auto count = static_cast<double>(rows_);
    axes_.y = chart_.page ? (chart_.page->y - margins) / count : chart_.axes.y;
    layout_.height = margins + count * axes_.y;
    double y = chart_.heading.empty() ? 0 : kHeading;
    for (std::size_t row = 0; row < rows_; ++row) {
      y += above[row];
      for (std::size_t column = 0; column < columns_; ++column) {
        const std::size_t i = row * columns_ + column;
        if (i < layout_.panels.size()) layout_.panels[i].top = y, layout_.panels[i].bottom = y + axes_.y;
      }
      y += axes_.y + below[row];
    }
    require(axes_.y, "height");
  }

  /// Sets the texts of the axis y. Returns the width of texts and name.
  double left_need(std::size_t i) {
    const ChartPanel& one = chart_.panels[i];
    PanelPlace& place = layout_.panels[i];
    place.y_ticks = ticks_along(one.y, axes_.y, kYTick, false);
    if (!one.y.has_texts) return kEdge + 4;
    if (!one.cells) return std::max(kLeft, 22 + widest_text(tick_texts(place.y_ticks)));
    const std::size_t count = std::max<std::size_t>(1, one.cells->rows.size());
    place.row_step = static_cast<std::size_t>(std::ceil(kChartText * static_cast<double>(count) / axes_.y));
    return std::max(kLeft, 22 + widest_text(one.cells->rows));
  }

  /// Returns the width of the scale of colours.
  [[nodiscard]] double bar_need(std::size_t i) const {
    const ChartPanel& one = chart_.panels[i];
    const ChartAxis scale{one.cells ? one.cells->low : one.dots->low, one.cells ? one.cells->high : one.dots->high, "",
                          true};
    const AxisTicks ticks = ticks_along(scale, axes_.y, kYTick, false);
    return 8 + kColorBar + 4 + widest_text(tick_texts(ticks)) + 16 + kEdge;
  }

  /// Sets the rows of a legend. The only legend of a chart continues down to the lowest axes.
  void measure_legend(std::size_t i) {
    const ChartPanel& one = chart_.panels[i];
    PanelPlace& place = layout_.panels[i];
    const auto needs_place = [](const ChartPanel& panel) { return !panel.legend.empty() || panel.cells || panel.dots; };
    const bool is_only = std::count_if(chart_.panels.begin(), chart_.panels.end(), needs_place) == 1;
    const double texts = one.x.has_texts ? kTexts - kEdge : 0;  // next to the texts below the axes
    const double bottom = is_only ? layout_.height - kEdge : place.bottom + texts;
    place.legend_rows = std::max<std::size_t>(1, static_cast<std::size_t>((bottom - place.top) / kLegendRow));
    place.legend_entries = one.legend.size();
    std::vector<std::string> labels{more_entries(one.legend.size())};
    if (one.legend.size() <= place.legend_rows) labels.clear();
    for (const LegendEntry& entry : one.legend) labels.push_back(entry.label);
    place.legend_column = kLegendSwatch + 2 * kLegendGap + widest_text(labels);
  }

  [[nodiscard]] double right_need(std::size_t i, std::size_t max_columns) {
    const ChartPanel& one = chart_.panels[i];
    if (one.cells || one.dots) return bar_need(i);
    if (one.legend.empty()) return kRight;
    PanelPlace& place = layout_.panels[i];
    const std::size_t columns = (one.legend.size() + place.legend_rows - 1) / place.legend_rows;
    place.legend_entries = std::min(one.legend.size(), max_columns * place.legend_rows);
    return kRight + static_cast<double>(std::min(columns, max_columns)) * place.legend_column + kEdge;
  }

  /// Returns the axes' width if legends have at most `max_columns` columns.
  double measure_columns(std::size_t max_columns) {
    left_.assign(columns_, 0), right_.assign(columns_, kRight);
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
      left_[i % columns_] = std::max(left_[i % columns_], left_need(i));
      right_[i % columns_] = std::max(right_[i % columns_], right_need(i, max_columns));
    }
    double margins = 0;
    for (std::size_t column = 0; column < columns_; ++column) margins += left_[column] + right_[column];
    const auto count = static_cast<double>(columns_);
    axes_.x = chart_.page ? (chart_.page->x - margins) / count : chart_.axes.x;
    return margins + count * axes_.x;
  }

  void measure_widths() {
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) measure_legend(i);
    std::size_t max_columns = std::max<std::size_t>(1, chart_.max_legend_columns);
    if (chart_.page) {
      const double least = 0.5 * chart_.page->x / static_cast<double>(columns_);
      for (max_columns = std::min<std::size_t>(max_columns, 20); max_columns > 1; --max_columns) {
        measure_columns(max_columns);
        if (axes_.x >= least) break;
      }
    }
    layout_.width = std::max(chart_.min_width, measure_columns(max_columns));
    require(axes_.x, "width");
    double x = 0;
    for (std::size_t column = 0; column < columns_; ++column) {
      const double left = x + left_[column];
      for (std::size_t i = column; i < layout_.panels.size(); i += columns_) {
        PanelPlace& place = layout_.panels[i];
        place.outer_left = x, place.left = left, place.right = left + axes_.x;
      }
      x = left + axes_.x + right_[column];
    }
  }

  void require(double length, const char* side) const {
    if (chart_.page && !(length >= kMinAxes))
      throw Error(
          fmt::format("the {} of the page leaves {:.0f} points to the axes between texts and legends, and "
                      "axes need {} points (14 mm)",
                      side, std::max(0.0, length), kMinAxes));
  }

  const Chart& chart_;
  std::size_t columns_, rows_ = 1;
  ChartLayout layout_;
  PagePoint axes_;
  std::vector<double> left_, right_;  // margins of each column of panels
};

}  // namespace

std::string more_entries(std::size_t count) {
  return fmt::format("and {} more", count);
}

ChartLayout lay_out_chart(const Chart& chart) {
  return ChartMeasure(chart).layout();
}

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
    for (const ChartRings& rings : panel.rings) add_rings(panel, place, rings);
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

  void add_rings(const ChartPanel& panel, const PanelPlace& place, const ChartRings& rings) {
    constexpr double kApart = 4.2;  // [points]
    PagePoint last{-1e9, 0};
    for (std::size_t i = 0; i < rings.points.x.size(); ++i) {
      const double x = rings.points.x[i], y = rings.points.y[i];
      if (!(x >= panel.x.low && x <= panel.x.high && y >= panel.y.low && y <= panel.y.high)) continue;
      const PagePoint at{place.x(panel.x, x), place.y(panel.y, y)};
      if (std::hypot(at.x - last.x, at.y - last.y) < kApart) continue;
      add_ring(at, rings.color);
      last = at;
    }
  }

  void add_ring(PagePoint at, const PageColor& color) {
    constexpr double kRadius = 1.6, kWidth = 0.8;  // [points]
    constexpr int kCorners = 12;
    std::vector<PagePoint> points;
    for (int i = 0; i <= kCorners; ++i) {
      const double angle = 2 * std::numbers::pi * (i % kCorners) / kCorners;
      points.push_back({at.x + kRadius * std::cos(angle), at.y + kRadius * std::sin(angle)});
    }
    page_.items.emplace_back(PageLine{points, color, kWidth, {}, 0});
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
      if (entry.is_ring)
        add_ring({corner.x + 0.5 * kLegendSwatch, y}, entry.style.color);
      else
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
