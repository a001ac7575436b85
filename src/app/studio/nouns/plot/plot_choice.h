// The curves that the plot shows, the reasons for it, and the curves that lie on each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/nouns/plot/plot_curves.h"
#include "ui/widgets/dashed_curve.h"

namespace taxel::ui {

struct PlotOptions {
  bool relative = true;         ///< plot fractions of the run's largest reading (Figure 4) instead of kPa
  bool responding_only = true;  ///< only taxels above 5 % of the largest reading
  bool all_sensors = true;      ///< taxels of all sensors, not only of the selected one
};

/// One curve of the plot.
struct ChosenCurve {
  TaxelKey key;
  std::size_t reading = 0;  ///< index in a trace row
  std::string label;        ///< name of the taxel, as the legend shows it
  int color = 0;            ///< colour number of the taxel
  bool selected = false;
  bool jumped = false;  ///< whether the simulation stopped at this taxel
  bool dashed = false;  ///< whether it is always drawn as dashes
  /// Place among curves that lie on each other, and their number. The first is drawn as a line, the others as dashes
  /// over it, each in the gaps of the others.
  int place = 0, of = 1;
};

struct PlotChoice {
  std::vector<ChosenCurve> curves;  ///< in the order of the sensors and their layouts
  PlotQuantity quantity = PlotQuantity::reading;
  ReadingUnit unit;
  double largest = 0;     ///< largest value of all taxels that have this unit, in SI
  bool relative = false;  ///< values are divided by the largest one; never for slip, which is a share already
  int other_units = 0;    ///< number of sensors that are left out because their values have another unit
  int without = 0;        ///< number of sensors that are left out because they do not have the quantity
};

/// Returns the taxel at which the simulation stopped, if it stopped at one.
[[nodiscard]] std::optional<TaxelKey> stopped_taxel(const RunView& run, const std::vector<SensorShown>& sensors);

/// Chooses the curves of the quantity of `curves`. With `responding_only` a taxel is left out if its peak is not above
/// kTaxelResponds of the largest reading, unless the taxel is selected or jumped. Needs a sensor.
[[nodiscard]] PlotChoice choose_curves(PlotCurves& curves, const std::vector<SensorShown>& sensors,
                                       const Selection& selection, const PlotOptions& options,
                                       const std::optional<TaxelKey>& jumped);

/// Returns the curves that stand out: the hovered one, otherwise the isolated ones among `curves`. Empty if all curves
/// are equal.
[[nodiscard]] std::vector<TaxelKey> focus_of(const std::vector<ChosenCurve>& curves,
                                             const std::optional<TaxelKey>& hovered,
                                             const std::vector<TaxelKey>& isolated);

/// Isolates a curve that was clicked, or frees it if it is isolated. With Shift the other isolated curves stay.
void click_isolated(std::vector<TaxelKey>& isolated, const TaxelKey& key, bool shift);

/// The look of a curve. Lengths are in pixels.
struct CurveStyle {
  double width = 1.8;
  bool dimmed = false;
  std::optional<DashLengths> dashes;  ///< empty for a line
};
[[nodiscard]] CurveStyle style_of(const ChosenCurve& curve, const std::vector<TaxelKey>& focus);

/// Returns the indices of the curves in the order in which they are drawn: dimmed ones first, dashes over lines.
[[nodiscard]] std::vector<std::size_t> drawing_order(const std::vector<ChosenCurve>& curves,
                                                     const std::vector<TaxelKey>& focus);

/// Returns the factor from readings in SI to the vertical axis.
[[nodiscard]] double plot_scale(const PlotChoice& choice, bool relative);

/// The values of curves at one x.
struct PlotReadout {
  struct Line {
    TaxelKey key;
    std::string label;
    int color = 0;
    double value = 0;  ///< in SI
  };
  double x = 0;             ///< x of the row that is read: travel [mm] or time [s]
  std::vector<Line> lines;  ///< curves that stand out, selected and jumped ones first, then the largest first
  std::size_t omitted = 0;  ///< number of other curves
};

/// Returns the values in the row that is nearest to x, of at most `most` curves. Empty without rows.
[[nodiscard]] std::optional<PlotReadout> read_curves(const PlotCurves& curves, const PlotChoice& choice,
                                                     const std::vector<TaxelKey>& focus, double x, std::size_t most);

}  // namespace taxel::ui
