// The state of a recording of a real sensor: the dialog that maps the columns of its table, its panel, and its curves
// over the plot.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/run/real/align.h"
#include "core/run/real/real_recording.h"

namespace taxel::ui {

/// The recording that is drawn over the run of one sensor.
struct RealShown {
  std::string file;
  int sensor = 0;  ///< index of the sensor in the run
  RealRecording recording;
  std::string unit;                    ///< unit of the recorded values; empty if unknown
  ColumnMapping mapping;               ///< meaning of the columns of the file
  double shift = 0;                    ///< shift that is added to the recorded times [s]
  std::optional<Alignment> alignment;  ///< alignment that gave the shift; empty if it was typed
  bool awaits_end = false;             ///< whether it is to be aligned when the run ends
  FitOptions options;                  ///< options of the fits
  std::vector<TaxelFit> fits;          ///< fit of each taxel; empty if not fitted
};
using RealShownPtr = std::shared_ptr<const RealShown>;

/// The curves of the recording in the plot.
struct RealCurves {
  RealShownPtr shown;         ///< recording that the curves were built from
  std::uint64_t edition = 0;  ///< edition of the trace that the curves were built for
  std::size_t rows = 0;       ///< number of rows of that trace
  std::size_t first = 0;      ///< index of the sensor's first reading in a row of the trace
  struct Curve {
    int taxel = 0;
    std::vector<double> x, y;  ///< x of the plot, and values in the unit of the reading
  };
  std::vector<Curve> curves;
};

struct RealState {
  using PerDocument = RealState;  ///< another document resets all of it
  // State of the dialog that assigns a meaning to each column:
  bool asks = false;
  std::string file;
  ColumnMapping mapping;
  TableLook look;       ///< extract of the file, read by the mapping
  std::string problem;  ///< reason why the file cannot be read by the mapping, or empty
  // State of the panel:
  FitOptions options;
  std::string refused;  ///< reason why the last button of the panel had no effect, or empty
  RealCurves curves;
  int points = 0;               ///< number of points that were drawn last
  bool comes_to_front = false;  ///< whether the panel comes to the front when it is drawn next
  RealShownPtr shown;           ///< the recording that is drawn over the run, or null
};

/// Draws the dialog that assigns a meaning to each column of a table.
void draw_real_dialog(WindowUi& ui, const Viewer& viewer, const Shown& shown, RealState& real);

/// Draws the samples of the recording in the present plot as points in the taxels' colours. Values of a taxel with a
/// gain are drawn as the readings that gave them. Values of other taxels are scaled so that the largest value is as
/// high as the largest reading. `scale` converts SI units to the plot's axis, and `largest` is the largest reading of
/// the run.
void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, const std::vector<SensorShown>& sensors);

/// Returns the same points for the page of the plot, whose curves are up to date. Empty if no recording is shown.
[[nodiscard]] std::vector<ChartRings> real_rings(const Selection& selection, const RunView& run, RealState& real,
                                                 const PlotState& plot, const PlotChoice& choice,
                                                 const std::vector<SensorShown>& sensors);

/// Parts equal curves whose taxels differ in the recording, so that each has its own entry in the legend.
void part_twins(std::vector<ChosenCurve>& curves, const RealState& real);

/// Returns whether the scenario of the run has come to its end, also while an earlier step is displayed.
[[nodiscard]] bool is_over(const RunView& run);

/// Returns the fits of all taxels as a table (CSV); see fits_csv(). There must be fits.
[[nodiscard]] std::string table_of_fits(const App& app);
/// Returns whether the gains of the recording are fitted.
[[nodiscard]] bool has_fits(const App& app);

/// A recording of a real sensor. Overlaying a recording opens the panel.
extern const Feature kReal;
/// Sets "real": the recording, its columns and the gains.
void dump_real(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
