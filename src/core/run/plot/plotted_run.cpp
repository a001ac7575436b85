#include "core/run/plot/plotted_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/table.h"
#include "core/run/recording/recording_files.h"

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

namespace {

/// Returns the number in a name such as "taxel_3", or nothing for other names.
std::optional<int> taxel_of_name(std::string_view name) {
  constexpr std::string_view kBegin = "taxel_";
  if (!name.starts_with(kBegin)) return std::nullopt;
  name.remove_prefix(kBegin.size());
  int id = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), id);
  return error == std::errc() && end == name.data() + name.size() && id >= 0 ? std::optional(id) : std::nullopt;
}

/// Reads a table, readings.csv, line by line, and number by number without copies of the fields, because a long run of
/// a large skin has tens of millions of numbers.
class ReadingsTable {
 public:
  ReadingsTable(std::string_view text, const std::string& file) : text_(text), file_(file) { run_.file = file; }

  PlottedRun read() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    names_ = header();
    find_columns();
    while (!text_.empty()) {
      ++line_;
      if (const std::string_view line = next_line(); !line.empty()) read_row(line);
    }
    if (run_.time.empty()) throw Error(file_, "has no row after its header");
    finish();
    return std::move(run_);
  }

 private:
  std::string_view next_line() {
    const std::size_t end = text_.find('\n');
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  std::vector<std::string> header() {
    ++line_;
    const std::vector<CsvRow> rows = parse_csv(std::string(next_line()), file_, ',');
    if (rows.empty()) throw Error(file_, "line 1", "must be the names of the columns, such as time,travel,taxel_0");
    return rows.front().fields;
  }

  /// Returns the sensor with this prefix of its columns, and adds it if it is new.
  std::size_t sensor_with(const std::string& prefix) {
    const auto [at, is_new] = sensors_.try_emplace(prefix, run_.sensors.size());
    if (is_new) run_.sensors.push_back({prefix, "", {}, {}, {}, {}, {}}), forces_.emplace_back();
    return at->second;
  }

  void find_columns() {
    std::set<std::string> seen;
    std::vector<std::pair<std::size_t, std::size_t>> places(names_.size(), {kNone, 0});
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const std::string& name = names_[i];
      if (!seen.insert(name).second) throw Error(file_, "line 1", fmt::format("has two columns \"{}\"", name));
      const std::size_t slash = name.rfind('/');
      const std::string prefix = slash == std::string::npos ? "" : name.substr(0, slash);
      const std::string last = slash == std::string::npos ? name : name.substr(slash + 1);
      if (const std::optional<int> id = taxel_of_name(last)) {
        const std::size_t sensor = sensor_with(prefix);
        places[i] = {sensor, run_.sensors[sensor].taxel_ids.size()};
        run_.sensors[sensor].taxel_ids.push_back(*id);
        run_.sensors[sensor].taxel_names.emplace_back();
      } else if (last.size() == 7 && last.starts_with("force_") && last[6] >= 'x' && last[6] <= 'z') {
        places[i] = {sensor_with(prefix), kForce + static_cast<std::size_t>(last[6] - 'x')};
      }
    }
    for (PlottedSensor& sensor : run_.sensors) sensor.readings.resize(sensor.taxel_ids.size());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto [sensor, place] = places[i];
      targets_.push_back(names_[i] == "time"     ? &run_.time
                         : names_[i] == "travel" ? &run_.travel
                         : sensor == kNone       ? nullptr
                         : place >= kForce       ? &forces_[sensor][place - kForce]
                                                 : &run_.sensors[sensor].readings[place]);
    }
    for (const char* needed : {"time", "travel"})
      if (!seen.contains(needed)) throw Error(file_, "line 1", fmt::format("has no column \"{}\"", needed));
    bool has_taxel = false;
    for (const PlottedSensor& sensor : run_.sensors) has_taxel = has_taxel || !sensor.taxel_ids.empty();
    if (!has_taxel) throw Error(file_, "line 1", "has no column of a taxel, such as \"taxel_0\"");
  }

  [[noreturn]] void refuse(std::size_t column, const std::string& message) const {
    throw Error(file_, fmt::format("line {}, column \"{}\"", line_, names_[column]), message);
  }

  void read_row(std::string_view line) {
    std::size_t column = 0;
    for (bool has_more = true; has_more; ++column) {
      const std::size_t comma = line.find(',');
      has_more = comma != std::string_view::npos;
      if (column < names_.size() && targets_[column] != nullptr)
        targets_[column]->push_back(number(line.substr(0, comma), column));
      line.remove_prefix(has_more ? comma + 1 : line.size());
    }
    if (column != names_.size())
      throw Error(file_, fmt::format("line {}", line_),
                  fmt::format("has {} fields, the header has {} columns", column, names_.size()));
  }

  double number(std::string_view field, std::size_t column) const {
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !(std::abs(value) <= kMaxPlotted))
      refuse(column, fmt::format("must be a number up to 1e100, is \"{}\"", field.substr(0, 40)));
    const std::vector<double>& earlier = *targets_[column];
    if (targets_[column] == &run_.time && !earlier.empty() && value < earlier.back())
      refuse(column, fmt::format("must not decrease, is {} after {}", value, earlier.back()));
    return value;
  }

  /// Joins the parts of the forces and sets the units.
  void finish() {
    for (std::size_t i = 0; i < run_.sensors.size(); ++i) {
      const auto& [x, y, z] = forces_[i];
      if (x.empty() || y.empty() || z.empty()) continue;
      for (std::size_t row = 0; row < x.size(); ++row) run_.sensors[i].force_W.emplace_back(x[row], y[row], z[row]);
      run_.sensors[i].unit = "Pa";
    }
    if (!run_.sensors.front().unit.empty())
      run_.notes.emplace_back("a table has no units: its readings are taken as Pa");
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1), kForce = static_cast<std::size_t>(1) << 32u;

  std::string_view text_;
  const std::string& file_;
  PlottedRun run_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>*> targets_;
  std::map<std::string, std::size_t> sensors_;              // index of the sensor with each prefix
  std::vector<std::array<std::vector<double>, 3>> forces_;  // by sensor
  int line_ = 0;
};

}  // namespace

PlottedRun parse_readings_csv(const std::string& text, const std::string& file) {
  return ReadingsTable(text, file).read();
}

namespace {

constexpr const char* kRunsFile = "runs.csv";
constexpr std::size_t kMaxPlottedRuns = 200;  // more panels cannot be read

PlottedRun read_studied_run(const fs::path& folder, const std::string& name) {
  const fs::path table = folder / name;
  fs::path archive = table;
  archive.replace_extension(".npz");
  std::error_code ignored;
  return read_plotted_run(fs::exists(archive, ignored) ? archive : table);
}

}  // namespace

bool is_study_folder(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / kRunsFile, ignored);
}

StudyFolder read_study_folder(const fs::path& folder) {
  const std::string file = (folder / kRunsFile).string();
  const std::vector<CsvRow> rows = parse_csv(read_file(file), file, ',');
  if (rows.empty() || rows.front().fields.front() != "file")
    throw Error(file, "line 1", "must begin with the column \"file\", as `taxel study` writes it");
  if (rows.size() < 2) throw Error(file, "lists no run");
  if (rows.size() - 1 > kMaxPlottedRuns)
    throw Error(file, fmt::format("lists {} runs; at most {} fit into one chart", rows.size() - 1, kMaxPlottedRuns));
  const std::vector<std::string>& names = rows.front().fields;
  StudyFolder study;
  std::set<std::string> values;  // of the second parameter
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    const std::string where = fmt::format("line {}", row.line);
    if (row.fields.size() != names.size())
      throw Error(file, where,
                  fmt::format("has {} fields, the header has {} columns", row.fields.size(), names.size()));
    const std::string& name = row.fields.front();
    if (name.empty() || fs::path(name).filename() != name)
      throw Error(file, where, fmt::format("must name a file of this folder, names \"{}\"", name));
    std::string title;
    for (std::size_t k = 1; k < names.size(); ++k)
      title += fmt::format("{}{} {}", k > 1 ? ", " : "", names[k], row.fields[k]);
    if (names.size() > 2) values.insert(row.fields[2]);
    study.runs.push_back({read_studied_run(folder, name), title});
  }
  const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(study.runs.size()))));
  study.columns = std::max<std::size_t>(1, names.size() > 2 ? values.size() : square);
  return study;
}

}  // namespace taxel
