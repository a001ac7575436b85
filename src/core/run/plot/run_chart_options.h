// The contents of a chart of a run, as the user chooses them, and its taxels.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace taxel {

enum class PlotAxis { automatic, travel, time };

/// The contents of a chart. Several panels are below each other. Without any, the chart has readings.
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

}  // namespace taxel
