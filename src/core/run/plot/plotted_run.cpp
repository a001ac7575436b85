#include "core/run/plot/plotted_run.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/plot/plot_units.h"
#include "core/run/recording/npz.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

PlottedSensor plotted_sensor(const Recording& recording, std::size_t index, bool is_calibrated,
                             const std::string& file) {
  const RecordedSensor& from = recording.sensors[index];
  PlottedSensor sensor{from.geom,
                       is_calibrated ? *from.calibrated_unit : from.reading_unit,
                       from.taxel_ids,
                       from.taxel_names,
                       {},
                       {},
                       {},
                       from.layout_json};
  sensor.readings.resize(from.taxel_ids.size());
  const bool has_errors = from.errors && !is_calibrated;
  if (has_errors) sensor.errors.resize(from.taxel_ids.size());
  for (const RecordedRow& row : recording.rows) {
    const SensorRecord& record = row.sensors[index];
    const std::vector<double>& values = is_calibrated ? record.calibrated : record.readings;
    for (std::size_t k = 0; k < sensor.readings.size(); ++k) {
      if (!(std::abs(values[k]) <= kMaxPlotted))
        throw Error(file, fmt::format("reading of taxel {}", sensor.taxel_ids[k]), "must be a number up to 1e100");
      sensor.readings[k].push_back(values[k]);
      if (has_errors) sensor.errors[k].push_back(std::min(record.errors[k], kMaxPlotted));
    }
    if (!(glm::length(record.force_W) <= kMaxPlotted)) throw Error(file, "force", "must be a number up to 1e100");
    sensor.force_W.push_back(record.force_W);
  }
  return sensor;
}

/// Returns true if a file is an archive of arrays by its first bytes, those of a zip archive.
bool is_archive(const fs::path& file) {
  return read_start(file, 2) == "PK";
}

}  // namespace

PlottedRun plotted_run(const Recording& recording, const std::string& file, bool is_calibrated) {
  PlottedRun run{file, {}, {}, {}, {}};
  for (const RecordedRow& row : recording.rows) {
    if (std::abs(row.travel) > kMaxPlotted || std::abs(row.time) > kMaxPlotted)
      throw Error(file, fmt::format("row {}", run.time.size()), "time and travel must be numbers up to 1e100");
    run.time.push_back(row.time);
    run.travel.push_back(row.travel);
  }
  for (std::size_t i = 0; i < recording.sensors.size(); ++i)
    if (!is_calibrated || recording.sensors[i].calibrated_unit)
      run.sensors.push_back(plotted_sensor(recording, i, is_calibrated, file));
  if (is_calibrated && run.sensors.empty())
    throw Error(file, "has no calibrated values: no layout of the run has a calibration");
  return run;
}

PlottedRun read_plotted_run(const fs::path& path, bool is_calibrated) {
  std::error_code ignored;
  fs::path file = path;
  if (fs::is_directory(path, ignored)) {
    file = path / "readings.npz";
    const fs::path table = path / (is_calibrated ? "calibrated.csv" : "readings.csv");
    if (!fs::exists(file, ignored)) {
      if (!fs::exists(table, ignored))
        throw Error(path.string(), "is no run: it has neither readings.npz nor " + table.filename().string());
      file = table;
    }
  }
  if (is_archive(file)) return plotted_run(read_recording(file), file.string(), is_calibrated);
  if (is_calibrated && !fs::is_directory(path, ignored))
    throw Error(file.string(), "is a table, which has no units: name calibrated.csv, or readings.npz");
  return parse_readings_csv(read_file(file), file.string());
}

}  // namespace taxel
