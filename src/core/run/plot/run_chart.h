// Charts of recorded runs: readings, heat maps and forces over travel or time.
#pragma once

#include <string>
#include <vector>

#include "core/base/page/chart.h"
#include "core/run/plot/plotted_run.h"
#include "core/run/plot/run_chart_options.h"

namespace taxel {

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

/// One run of a study.
struct StudiedRun {
  PlottedRun run;
  std::string title;  ///< such as "depth 0.001, seed 2"
};

/// Returns one small panel per run, all with the same axes and the same look of each taxel. `columns` is the number of
/// panels in a row. Throws Error as run_chart() does, also if the runs have different taxels or units. There is at
/// least one run.
[[nodiscard]] RunChart study_chart(const std::vector<StudiedRun>& runs, std::size_t columns,
                                   const RunChartOptions& options);

}  // namespace taxel
