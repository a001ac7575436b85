// Charts of recorded runs: readings, heat maps and forces over travel or time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/page/chart.h"
#include "core/run/plot/plotted_run.h"

namespace taxel {

enum class PlotAxis { automatic, travel, time };

/// The contents of a chart, as the user chooses them. Several panels are below each other. Without any, the chart has
/// readings.
struct RunChartOptions {
  bool has_readings = false;    ///< readings in their unit
  bool has_normalised = false;  ///< readings as fractions of the largest reading of all plotted taxels
  bool has_heat_map = false;    ///< readings of all taxels, or of `taxels`, as colours
  bool has_forces = false;      ///< parts and size of the contact force
  PlotAxis over = PlotAxis::automatic;
  std::string sensor;               ///< geom of the only sensor, or empty for all
  std::vector<std::string> taxels;  ///< ids, names, or GEOM/ID; empty for those that respond
  bool has_all_taxels = false;
};

/// One taxel whose readings are plotted.
struct PlottedTaxel {
  std::size_t sensor = 0, taxel = 0;  ///< indices in the run
  std::string label;                  ///< name in the legend
  double peak = 0;                    ///< reading of the largest size
  std::size_t peak_row = 0;           ///< its first row
};

// The taxels of a chart: those that the user names, all, or those that respond.

/// Returns the indices of the plotted sensors: all with taxels, or the one that the options name. Throws
/// Error naming the run's file if there is no such sensor.
[[nodiscard]] std::vector<std::size_t> chosen_sensors(const PlottedRun& run, const RunChartOptions& options);

/// Returns all taxels of the plotted sensors with their peaks, without names in their labels if `has_names` is false.
/// Throws Error as chosen_sensors() does.
[[nodiscard]] std::vector<PlottedTaxel> taxels_of(const PlottedRun& run, const RunChartOptions& options,
                                                  bool has_names);

/// Returns the taxels that the options choose among `all`. `peaks` are parallel to `all` and decide which respond: one
/// above 5 % of the largest peak of its unit. Throws Error naming the run's file if a taxel of the options is unknown.
[[nodiscard]] std::vector<PlottedTaxel> chosen_taxels(const PlottedRun& run, const RunChartOptions& options,
                                                      const std::vector<PlottedTaxel>& all,
                                                      const std::vector<double>& peaks);

/// A chart, and the facts about it that the user wants to know.
struct RunChart {
  Chart chart;
  bool is_over_travel = false;
  std::vector<PlottedTaxel> taxels;  ///< the curves of readings
  std::vector<std::string> notes;
};

/// Returns the chart of a run. A taxel responds if its peak is above 5 % of the largest peak of all taxels of its unit.
/// `automatic` is travel if the travel grows from nearly every row to the next and never decreases, otherwise time.
/// Throws Error naming the run's file if a sensor or a taxel is unknown, if forces are wanted and not recorded, or if a
/// heat map is wanted over travel that decreases.
[[nodiscard]] RunChart run_chart(const PlottedRun& run, const RunChartOptions& options);

/// Returns one small panel per run, all with the same axes and the same look of each taxel. `columns` is the number of
/// panels in a row. Throws Error as run_chart() does, also if the runs have different taxels or units. There is at
/// least one run.
[[nodiscard]] RunChart study_chart(const std::vector<StudiedRun>& runs, std::size_t columns,
                                   const RunChartOptions& options);

}  // namespace taxel
