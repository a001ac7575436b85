// The taxels of a chart: those that the user names, all, or those that respond.
#pragma once

#include <vector>

#include "core/run/plot/plotted_run.h"
#include "core/run/plot/run_chart_options.h"

namespace taxel {

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

}  // namespace taxel
