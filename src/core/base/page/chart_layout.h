// The places of the axes, ticks and legends of a chart.
#pragma once

#include <string>
#include <vector>

#include "core/base/page/chart.h"

namespace taxel {

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
