// The table readings.csv as columns of numbers. Rows are read number by number without copies of the fields, because a
// long run of a large skin has tens of millions of numbers.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text/csv.h"
#include "core/run/plot/plot_units.h"
#include "core/run/plot/plotted_run.h"

namespace taxel {
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

/// Reads one table, line by line.
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

}  // namespace taxel
