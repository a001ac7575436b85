// A run as columns of numbers, for charts. Read from an archive of arrays or from a table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

/// The values of one sensor in all rows.
struct PlottedSensor {
  std::string geom;  ///< name of the geom; empty if a table has only one sensor
  std::string unit;  ///< unit of the readings; empty if unknown
  std::vector<int> taxel_ids;
  std::vector<std::string> taxel_names;       ///< parallel to `taxel_ids`; empty texts in a table
  std::vector<std::vector<double>> readings;  ///< readings of each taxel, one per row
  std::vector<std::vector<double>> errors;    ///< error bars of `readings`; empty if not recorded
  std::vector<dvec3> force_W;                 ///< contact force on the sensor, world frame [N]; empty if not recorded
  std::string layout_json = {};               ///< the layout, or empty if a table has none
};

struct PlottedRun {
  std::string file;            ///< path of the file
  std::vector<double> time;    ///< [s], ascending
  std::vector<double> travel;  ///< travel of the mocap body [m]
  std::vector<PlottedSensor> sensors;
  std::vector<std::string> notes;  ///< sentences about assumptions
};

/// Returns the columns of a recording: readings, or calibrated values of the sensors that have them. Throws Error
/// naming `file` if no sensor has calibrated values, or a number is beyond kMaxPlotted.
[[nodiscard]] PlottedRun plotted_run(const Recording& recording, const std::string& file, bool is_calibrated = false);

/// Reads a table as recording_to_csv() and calibrated_to_csv() write it. Columns are found by their names; others than
/// time, travel, taxel_<id> and force_x, force_y, force_z are ignored. A table has no units: readings next to forces
/// are taken as Pa, with a note. Throws Error(file, "line 7, column \"taxel_3\"", ...) if a column is missing or twice,
/// there is no row, a row has another length, a field is not a number up to kMaxPlotted, or time decreases.
[[nodiscard]] PlottedRun parse_readings_csv(const std::string& text, const std::string& file);

/// Reads a run: a folder with readings.npz or readings.csv, or such a file, whatever its name. Throws Error naming the
/// file. `is_calibrated` as for plotted_run(); from a folder without an archive, calibrated.csv is read.
[[nodiscard]] PlottedRun read_plotted_run(const std::filesystem::path& path, bool is_calibrated = false);

}  // namespace taxel
