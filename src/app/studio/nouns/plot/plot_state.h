// The plot of readings over travel, as in Figure 4 of the paper, or over time: its quantities, the curves of a run with
// all rows, thinned only to the resolution of the screen, the choice among them, and the plot as it was drawn.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/nouns/plot/close_up.h"
#include "core/base/page/chart.h"
#include "core/base/page/curve.h"
#include "core/base/page/page.h"
#include "core/run/step.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

/// The quantities of a taxel that the plot can show: its reading, its shear, and the share of its field that slips.
enum class PlotQuantity : std::uint8_t { reading, shear, slip };

inline constexpr PlotQuantity kPlotQuantities[] = {PlotQuantity::reading, PlotQuantity::shear, PlotQuantity::slip};

/// Returns whether a sensor has the quantity in the displayed step.
[[nodiscard]] bool has_quantity(const SensorShown& sensor, PlotQuantity quantity);

/// Returns the unit of a sensor's quantity: that of its readings, or percent for slip.
[[nodiscard]] ReadingUnit quantity_unit(const SensorShown& sensor, PlotQuantity quantity);

/// Returns why no sensor has the quantity, and how it gets it. Empty if a sensor has it.
[[nodiscard]] std::string why_missing(const std::vector<SensorShown>& sensors, PlotQuantity quantity);

/// Returns the wanted quantity if a sensor has it, otherwise readings.
[[nodiscard]] PlotQuantity available_quantity(const std::vector<SensorShown>& sensors, PlotQuantity wanted);

/// Returns the values of a quantity in a row, for the taxels of all sensors in order. Empty if the row has none.
[[nodiscard]] std::span<const double> values_of(const TraceRow& row, PlotQuantity quantity);

/// The trace of a run as curves.
struct PlotCurves {
  std::uint64_t edition = 0;  ///< edition of the plotted trace
  bool by_travel = false;
  PlotQuantity quantity = PlotQuantity::reading;
  std::vector<double> x;                      ///< travel [mm] or time [s]
  std::vector<std::vector<double>> readings;  ///< values of each taxel of all sensors, in SI units
  std::vector<double> peaks;                  ///< parallel to `readings`
  double largest = 0;                         ///< largest of all readings [Pa]
  std::optional<double> polished_from;        ///< first x with polished samples; empty if all are polished
  std::vector<CurvePoints> drawn;             ///< parallel to `readings`; an empty entry is not thinned yet
  std::array<double, 3> drawn_for{};          ///< column, tolerance and scale of `drawn`
  std::vector<std::size_t> paired;            ///< readings that were searched for `leaders`
  std::vector<int> leaders;                   ///< parallel to `paired`: see find_leaders()
  std::vector<int> equals;                    ///< leader of each curve that equals it within kEqualCurves, or -1
  std::size_t paired_rows = 0;                ///< number of rows that were searched for `leaders`
  bool is_growing = false;                    ///< whether the last update added rows
};

/// Updates the curves from a trace. If the trace only grew since the last update, only new rows are read. Curves are
/// over travel if `by_travel`, otherwise over time. Rows without the quantity have the value 0.
void update_curves(PlotCurves& curves, const Trace& trace, bool by_travel,
                   PlotQuantity quantity = PlotQuantity::reading);

/// Returns the curve of one taxel with its readings times `scale`; see thin_curve(). `tolerance` is in scaled readings.
/// The result is retained until a call with other arguments.
const CurvePoints& drawn_curve(PlotCurves& curves, std::size_t reading, double column, double tolerance, double scale);

/// Returns, for each of `readings`, the index in `readings` of the curve that it follows, or -1; see find_leaders().
/// `twins` is called for a new search. While rows are added, the result may be based on up to a tenth fewer rows.
const std::vector<int>& leaders_among(PlotCurves& curves, const std::vector<std::size_t>& readings,
                                      const std::function<std::vector<int>()>& twins = nullptr);

/// Largest distance of two curves that count as equal, as a fraction of the peak of the later one: less than a pixel in
/// a plot of 500 pixels.
inline constexpr double kEqualCurves = 0.002;

/// Returns whether two curves differ by no more than kEqualCurves. A curve without a value above 0 equals none. A value
/// that is missing in one of them, which is NaN, has to be missing in the other too.
[[nodiscard]] bool are_equal_curves(std::span<const double> first, std::span<const double> second);

struct PlotOptions {
  bool relative = true;         ///< plot fractions of the run's largest reading (Figure 4) instead of kPa
  bool responding_only = true;  ///< only taxels above 5 % of the largest reading
  bool all_sensors = true;      ///< taxels of all sensors, not only of the selected one
  bool whole_run = false;       ///< ANALYSE has the whole run on its axes, not only the part with contact
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
  int twin = -1;  ///< index of the earlier curve that it equals, or -1
};

/// One entry of a legend: a taxel, or several whose curves are equal.
struct LegendEntry {
  std::string label;                ///< "4", or "4 = 10"
  std::vector<std::size_t> curves;  ///< indices of its curves, ascending
};
[[nodiscard]] std::vector<LegendEntry> legend_entries(const std::vector<ChosenCurve>& curves);

/// Sets ChosenCurve::twin of curves that are equal.
void find_twins(PlotCurves& curves, std::vector<ChosenCurve>& chosen);

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

/// Returns the curves that stand out: the hovered one, otherwise the isolated ones among `curves`, with those that are
/// equal to them. Empty if all are drawn alike.
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

/// The plot as it was drawn in the last frame.
struct PlotShown {
  PlotChoice choice;
  std::vector<TaxelKey> focus;  ///< curves that stand out; empty if all are equal
  std::optional<PlotReadout> readout;
  int errors = 0;                 ///< number of drawn error bars
  bool in_analyse = false;        ///< whether the panel is the large plot of ANALYSE
  bool may_magnify = true;        ///< whether a close-up is drawn; in ANALYSE a panel in front asks for it
  std::string answer;             ///< title of the panel whose answer is drawn in ANALYSE, or empty
  bool fits_contact = false;      ///< whether only the part with contact is on the axes
  double x_begin = 0, x_end = 0;  ///< ends of the x axis
  std::optional<CloseUpView> close_up;
  double change_pixels = 0;  ///< height of the magnified change [pixels]
  EarlierCurvePtr before;    ///< readings before the remedy that the layout has now, or null
};

/// The part of the plot's state that belongs to the document.
struct PlotOfDocument {
  PlotQuantity quantity = PlotQuantity::reading;  ///< chosen quantity; readings are shown if no sensor has it
  std::vector<TaxelKey> isolated;                 ///< curves that stand out until they are clicked again
  std::optional<PlotCloseUp> close_up;            ///< part that is magnified; empty for the whole run
  ExactCurvePtr exact;                            ///< exact readings of a close-up, or null
  EarlierCurvePtr before;                         ///< readings before the last remedy, or null
  PlotShown shown;                                ///< empty if the panel is closed
};

struct PlotState : PlotOfDocument {
  using PerDocument = PlotOfDocument;
  PlotOptions options;
  PlotCurves curves;
};

/// Names and ends of the axes that window and page share.
struct PlotAxes {
  std::string x_name, y_name;  ///< with their units
  double x_end = 1, y_end = 1;
  double x_begin = 0, y_begin = 0;
};

/// Limits the x axis to the part of the run with contact, and a little more. Leaves the axes of a run without contact.
void fit_to_contact(PlotAxes& axes, const RunView& run);

/// Returns whether the plots have only the part with contact on their axes: in ANALYSE, unless the whole run is wanted.
/// The axes of a run that goes on would move.
[[nodiscard]] bool fits_contact(const App& app);

/// Shows the whole run, or only the part with contact, on the axes of ANALYSE.
struct ToggleWholeRun {};
void carry_out(const ToggleWholeRun& command, App& app);

/// Returns the axes of a run: the whole length of its scenario if that is known, otherwise up to the displayed step.
[[nodiscard]] PlotAxes plot_axes(const RunView& run, const PlotChoice& choice, bool relative);

/// Returns the colour of a curve on paper: the colour that the curve has in the window's light theme.
[[nodiscard]] PageColor page_color(int number, bool dimmed);

/// Returns the plot as a page in vectors, for SVG and PDF files: on white, with a legend: 6 x 3.6 inches, and wider by
/// the columns of a long legend. Curves that do not stand out from `focus` are pale. `rings` are those of a real
/// recording.
[[nodiscard]] Page plot_page(PlotCurves& curves, const PlotChoice& choice, const std::vector<TaxelKey>& focus,
                             const PlotAxes& axes, bool relative, const std::string& title,
                             std::vector<ChartRings> rings = {});

struct RealState;

/// Returns the page of the plot as its panel shows it, with the rings of a real recording, also if the panel is closed.
/// Empty without curves.
[[nodiscard]] std::optional<Page> displayed_plot(const RunView& run, const Selection& selection, PlotState& plot,
                                                 RealState& real, const std::string& title);

/// Readings over travel or time.
extern const Feature kPlot;
/// Sets "plot": the drawn curves and the values at the pointer.
void dump_plot(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
