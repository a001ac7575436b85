// A run as columns of numbers, for charts, read from an archive of arrays or from a table; the runs in the folder of a
// study; and the units of their axes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

/// Sizes of numbers that charts show: their sums and quotients are finite.
inline constexpr double kMinPlotted = 1e-100, kMaxPlotted = 1e100;

/// A unit and the factor from SI to it.
struct PlotUnit {
  std::string text;
  double scale = 1;
};

/// Returns the unit for values up to `largest`: Pa, kPa or MPa; mN, N or kN. Other units have no prefixes.
[[nodiscard]] inline PlotUnit plot_unit(const std::string& unit, double largest) {
  if (unit == "N" && largest > 0 && largest < 0.1) return {"mN", 1e3};
  if (unit != "Pa" && unit != "N") return {unit, 1};
  if (largest >= 1e6) return {"M" + unit, 1e-6};
  if (largest >= 1e3) return {"k" + unit, 1e-3};
  return {unit, 1};
}

/// Returns the name of an axis with its unit: "reading (kPa)".
[[nodiscard]] inline std::string named_with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

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

/// One run of a study.
struct StudiedRun {
  PlottedRun run;
  std::string title;  ///< such as "depth 0.001, seed 2"
};

/// The folder that `taxel study` writes: runs.csv and a file per run.
struct StudyFolder {
  std::vector<StudiedRun> runs;  ///< at least one
  std::size_t columns = 1;       ///< number of panels in a row: values of the second parameter, or near a square
};

/// Returns true if a folder has runs.csv.
[[nodiscard]] bool is_study_folder(const std::filesystem::path& folder);

/// Reads the runs that runs.csv lists, each from its archive of arrays, or from its table if it has none. Throws
/// Error(file, "line 3", ...) if runs.csv is not such a list or names a file outside of the folder.
[[nodiscard]] StudyFolder read_study_folder(const std::filesystem::path& folder);

}  // namespace taxel
