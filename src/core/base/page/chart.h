// Charts of curves and of cells with axes and legends: their content, their layout on a page, and the page itself. The
// window draws the same layout.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/page/curve.h"
#include "core/base/page/page.h"

namespace taxel {

/// An axis of a panel. Its ends differ, and `low` is below `high`.
struct ChartAxis {
  double low = 0, high = 1;
  std::string name;       ///< with its unit
  bool has_texts = true;  ///< false if the neighbouring panel has the same axis with its texts
};

/// The look of a curve. Lengths are in points.
struct LineStyle {
  PageColor color{};
  double width = 1.1;
  std::vector<double> dashes = {};  ///< lengths of dash and gap in turn; empty for a solid line
  double dash_start = 0;
};

/// A curve in the units of its axes. Its x may turn back.
struct ChartCurve {
  CurvePoints points;
  LineStyle style;
};

/// Measured points as rings of one colour, in the units of the axes.
struct ChartRings {
  CurvePoints points;
  PageColor color{};
};

/// An entry of a legend, next to the axes, where no curve is.
struct LegendEntry {
  std::string label;
  LineStyle style;
  std::optional<LineStyle> below = {};  ///< look of the curve on which the curve lies
  bool is_ring = false;                 ///< whether the entry is about rings, not about a curve
};

/// Values in rows of cells, as colours, with the scale of the colours next to the axes.
struct ChartCells {
  std::vector<double> edges;                ///< ends of the columns on the axis x, ascending; one more than columns
  std::vector<std::string> rows;            ///< names of the rows, from the top
  std::vector<std::vector<double>> values;  ///< values of each row, in the columns
  double low = 0, high = 1;                 ///< values of the first and of the last colour
  std::string name;                         ///< name of the values, with their unit
};

/// Points as small squares whose colours are values, with the scale of the colours next to the axes.
struct ChartDots {
  std::vector<double> x, y, values;  ///< places on the axes, and the values there
  double low = 0, high = 1;          ///< values of the first and of the last colour
  std::string name;                  ///< name of the values, with their unit
};

/// One pair of axes with curves, dots or cells, and their legend.
struct ChartPanel {
  std::string title;  ///< may be empty
  ChartAxis x, y;
  std::vector<ChartCurve> curves;  ///< the lowest first
  std::vector<ChartRings> rings;   ///< over the curves; points outside of the axes are left out
  std::vector<LegendEntry> legend;
  std::optional<ChartCells> cells;  ///< the axis y has the names of its rows
  std::optional<ChartDots> dots;    ///< below the curves
};

struct Chart {
  std::string title;               ///< name of the document
  std::string heading;             ///< drawn above all panels; may be empty
  std::vector<ChartPanel> panels;  ///< row by row
  std::size_t columns = 1;         ///< number of panels next to each other
  PagePoint axes{320, 212};        ///< width and height of the axes of each panel, if the page has no size [points]
  double min_width = 0;            ///< smallest width of a page around the axes [points]
  std::size_t max_legend_columns = 1000;
  std::optional<PagePoint> page;  ///< width and height of the page; not set for a page around the axes [points]
};

/// Smallest axes, both ways [points].
inline constexpr double kMinAxes = 40;

/// Returns the chart on white. Curves are thinned to a resolution of 0.25 points, in which the lowest and the highest
/// value remain. A ring that would cover the one before it is left out. A legend has columns to the right of its axes.
/// On a page of a given size, legends take at most half of the width; entries that have no place become "and 7 more".
/// Throws Error if a page of the given size leaves less than kMinAxes to the axes.
[[nodiscard]] Page chart_page(const Chart& chart);

/// The numbers at which an axis has ticks.
struct AxisTicks {
  std::vector<double> values;  ///< ascending
  double step = 0;             ///< distance of two ticks; 0 if there are fewer than two
};

/// Returns at most `most` + 1 round numbers from `low` to `high`: multiples of 1, 2 or 5 times a power of 10. A
/// range with fewer than two of them gets the next finer ones. Returns `low` alone if the range is empty or an end is
/// not finite.
[[nodiscard]] AxisTicks axis_ticks(double low, double high, int most);

/// Returns the text of each tick, all with as many decimals as the step needs: "0.0", "0.5", "1.0". Very large and very
/// small numbers have a power of 10: "2e-07".
[[nodiscard]] std::vector<std::string> tick_texts(const AxisTicks& ticks);

inline constexpr double kChartText = 9, kLegendRow = 12, kLegendSwatch = 20, kLegendGap = 6;  ///< sizes [points]
inline constexpr double kColorBar = 10;  ///< width of the scale of colours [points]

/// The places of one panel on the page [points].
struct PanelPlace {
  double left = 0, top = 0, right = 0, bottom = 0;  ///< edges of the axes
  double outer_left = 0;                            ///< left end of the texts of the axis y
  AxisTicks x_ticks, y_ticks;
  std::size_t row_step = 1;        ///< number of rows of cells from one name to the next
  std::size_t legend_rows = 1;     ///< entries in a column of the legend
  std::size_t legend_entries = 0;  ///< entries that have a place; the last one is "and 7 more" if some are left out
  double legend_column = 0;        ///< width of a column of the legend

  /// Returns the place of a value on an axis.
  [[nodiscard]] double x(const ChartAxis& axis, double value) const {
    return left + (right - left) * (value - axis.low) / (axis.high - axis.low);
  }
  [[nodiscard]] double y(const ChartAxis& axis, double value) const {
    return bottom - (bottom - top) * (value - axis.low) / (axis.high - axis.low);
  }
  /// Returns the upper left corner of an entry of the legend.
  [[nodiscard]] PagePoint legend_at(std::size_t entry) const {
    return {right + 12 + static_cast<double>(entry / legend_rows) * legend_column,
            top + static_cast<double>(entry % legend_rows) * kLegendRow};
  }
};

struct ChartLayout {
  double width = 0, height = 0;  ///< size of the page [points]
  std::vector<PanelPlace> panels;
};

/// Returns the places of all panels. All axes have the same size, and axes in a row or a column are aligned. No text
/// and no legend covers axes. Throws Error as chart_page() does.
[[nodiscard]] ChartLayout lay_out_chart(const Chart& chart);

/// Returns the text for entries that a legend leaves out.
[[nodiscard]] std::string more_entries(std::size_t count);

}  // namespace taxel
