// Charts of curves and of cells with axes and legends. The window and the command line draw them (chart_page.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/page/page.h"
#include "core/base/page/thin_curve.h"

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

/// An entry of a legend, next to the axes, where no curve is.
struct LegendEntry {
  std::string label;
  LineStyle style;
  std::optional<LineStyle> below = {};  ///< look of the curve on which the curve lies
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

}  // namespace taxel
