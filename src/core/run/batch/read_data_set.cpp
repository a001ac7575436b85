// Reads data sets: their episodes, their comparison with a run, and the study that a data set may be.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <ranges>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"
#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"
#include "core/run/batch/write_data_set.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEpisodesFile = "meta/episodes/chunk-000/file-000.parquet";
constexpr const char* kLayoutsFile = "meta/layouts.parquet";

/// Reads a whole column of one type. Throws Error naming file and column if it is of another type.
template <class Value>
std::vector<Value> whole_column(const ParquetFile& file, const std::string& name) {
  ParquetCells cells = file.all_cells(name);
  auto* values = std::get_if<std::vector<Value>>(&cells.values);
  if (values == nullptr || file.columns()[file.column(name)].is_list)
    throw Error(file.name(), name, "is of another type than in a data set");
  return std::move(*values);
}

template <class Value>
std::vector<std::vector<Value>> whole_lists(const ParquetFile& file, const std::string& name) {
  ParquetCells cells = file.all_cells(name);
  auto* values = std::get_if<std::vector<Value>>(&cells.values);
  if (values == nullptr || !file.columns()[file.column(name)].is_list)
    throw Error(file.name(), name, "is of another type than in a data set");
  std::vector<std::vector<Value>> lists;
  std::size_t first = 0;
  for (const std::int32_t length : cells.lengths) {
    const auto begin = std::make_move_iterator(values->begin() + static_cast<std::ptrdiff_t>(first));
    lists.emplace_back(begin, begin + length);
    first += static_cast<std::size_t>(length);
  }
  return lists;
}

std::size_t place_of(const char* const* begin, const char* const* end, std::string_view name) {
  return static_cast<std::size_t>(std::find(begin, end, name) - begin);
}

/// The columns of the table of episodes.
struct EpisodeTable {
  explicit EpisodeTable(const ParquetFile& file) : tasks(whole_lists<std::string>(file, "tasks")) {
    for (const char* name : kEpisodeNumbers) numbers.push_back(whole_column<std::int64_t>(file, name));
    for (const char* name : kEpisodeTexts) texts.push_back(whole_column<std::string>(file, name));
    for (const char* name : kEpisodeValues) values.push_back(whole_column<double>(file, name));
  }
  [[nodiscard]] std::int64_t number(std::string_view name, std::size_t row) const {
    return numbers[place_of(kEpisodeNumbers.begin(), kEpisodeNumbers.end(), name)][row];
  }
  std::vector<std::vector<std::string>> tasks;
  std::vector<std::vector<std::int64_t>> numbers;
  std::vector<std::vector<std::string>> texts;
  std::vector<std::vector<double>> values;
};

EpisodeEntry entry_of(const EpisodeTable& table, std::size_t row) {
  EpisodeEntry entry;
  entry.index = table.number("episode_index", row);
  entry.rows = table.number("length", row);
  entry.task = table.tasks[row].empty() ? "" : table.tasks[row].front();
  entry.job = table.texts[0][row];
  entry.scenario = table.texts[1][row];
  entry.changes = table.texts[2][row];
  entry.line = static_cast<int>(table.number("taxel/line", row));
  entry.seed = table.number("taxel/seed", row);
  entry.layout = static_cast<std::size_t>(table.number("taxel/layout", row));
  entry.summary = {table.values[1][row], table.values[2][row], static_cast<int>(table.number("taxel/peak_taxel", row)),
                   table.values[0][row]};
  entry.file = fmt::format("data/chunk-{:03}/file-{:03}.parquet", table.number("data/chunk_index", row),
                           table.number("data/file_index", row));
  entry.row_group = static_cast<std::size_t>(table.number("taxel/row_group", row));
  entry.first_row = table.number("taxel/first_row", row);
  return entry;
}

/// Returns the values of `count` rows from `first` as numbers of 64 bits.
EpisodeColumn part_of_rows(const ParquetColumn& column, const ParquetCells& cells, std::size_t first,
                           std::size_t count) {
  EpisodeColumn part{column.name, 1, column.is_list, {}};
  std::size_t begin = first, values = count;
  if (column.is_list) {
    const auto lengths = cells.lengths.begin();
    const auto at = lengths + static_cast<std::ptrdiff_t>(first), end = at + static_cast<std::ptrdiff_t>(count);
    begin = std::accumulate(lengths, at, std::size_t{0}, std::plus<std::size_t>());
    values = std::accumulate(at, end, std::size_t{0}, std::plus<std::size_t>());
    part.width = count > 0 ? values / count : 0;
  }
  std::visit(
      [&]<class Value>(const std::vector<Value>& all) {
        if constexpr (!std::is_same_v<Value, std::string>)
          for (std::size_t i = begin; i < begin + values; ++i) part.values.push_back(static_cast<double>(all[i]));
      },
      cells.values);
  return part;
}

}  // namespace

DataSet::DataSet(const fs::path& folder) : folder_(folder) {
  read_layouts();
  read_episodes();
}

void DataSet::read_layouts() {
  const ParquetFile file(folder_ / kLayoutsFile);
  auto keys = whole_column<std::string>(file, "key");
  std::set<std::string_view> distinct_keys;
  for (const std::string& key : keys)
    if (!distinct_keys.insert(key).second)
      throw Error(file.name(), "key", fmt::format("is damaged: layout \"{}\" is listed twice", key.substr(0, 80)));
  auto names = whole_column<std::string>(file, "name"), units = whole_column<std::string>(file, "unit");
  auto layouts = whole_column<std::string>(file, "layout");
  auto calibrated = whole_column<std::string>(file, "calibrated_unit");
  auto ids = whole_lists<std::int64_t>(file, "taxel_ids");
  auto taxels = whole_lists<std::string>(file, "taxel_names");
  for (std::size_t i = 0; i < keys.size(); ++i)
    layouts_.push_back({std::move(keys[i]), std::move(layouts[i]), std::move(names[i]), std::move(ids[i]),
                        std::move(taxels[i]), std::move(units[i]), std::move(calibrated[i])});
}

void DataSet::read_episodes() {
  const ParquetFile file(folder_ / kEpisodesFile);
  const EpisodeTable table(file);
  for (std::size_t row = 0; row < static_cast<std::size_t>(file.rows()); ++row) {
    EpisodeEntry entry = entry_of(table, row);
    const bool has_place = entry.layout < layouts_.size() && entry.rows > 0 && entry.first_row >= 0;
    if (!has_place || entry.index != static_cast<std::int64_t>(row))
      throw Error(file.name(), fmt::format("row {}", row), "is damaged: the episode has no place in the data set");
    episodes_.push_back(std::move(entry));
  }
}

Episode DataSet::read_episode(std::size_t index) const {
  const EpisodeEntry& entry = episodes_.at(index);
  const ParquetFile file(folder_ / entry.file);
  const bool has_rows = entry.row_group < file.row_groups() && entry.first_row <= file.rows(entry.row_group) &&
                        entry.rows <= file.rows(entry.row_group) - entry.first_row;
  if (!has_rows) throw Error(file.name(), fmt::format("has not the rows of episode {}", entry.index));
  Episode episode{entry.rows, {}, entry.summary};
  for (std::size_t i = 0; i < file.columns().size(); ++i) {
    const ParquetColumn& column = file.columns()[i];
    if (std::ranges::find(kIndexColumns, column.name) != kIndexColumns.end()) continue;
    episode.columns.push_back(part_of_rows(column, file.cells(entry.row_group, i),
                                           static_cast<std::size_t>(entry.first_row),
                                           static_cast<std::size_t>(entry.rows)));
  }
  return episode;
}

namespace {

const EpisodeColumn* column_of(const Episode& episode, const char* name) {
  const auto found = std::ranges::find(episode.columns, name, &EpisodeColumn::name);
  return found != episode.columns.end() ? &*found : nullptr;
}

/// The columns of an episode that a trace has as well.
struct ComparedColumns {
  const EpisodeColumn *time, *travel, *tactile;
};

bool has_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

double rounded(double value, int bits) {
  constexpr int kFloat32 = 32;
  return bits == kFloat32 ? static_cast<double>(static_cast<float>(value)) : value;
}

void compare_row(const TraceRow& row, const ComparedColumns& columns, std::size_t r, int bits, ReplayCheck& check) {
  const double time = columns.time->values[r];
  const bool has_same_times = has_same_bits(rounded(row.time, bits), time) &&
                              has_same_bits(rounded(row.travel, bits), columns.travel->values[r]);
  bool is_equal = has_same_times;
  const std::size_t width = columns.tactile->width;
  for (std::size_t k = 0; k < width; ++k) {
    const double live = rounded(row.readings[k], bits), recorded = columns.tactile->values[r * width + k];
    if (has_same_bits(live, recorded)) continue;
    is_equal = false;
    const double difference = std::abs(live - recorded);
    if (difference <= check.largest) continue;
    check.largest = difference;
    check.largest_taxel = k;
    check.largest_time = time;
  }
  check.has_other_times = check.has_other_times || !has_same_times;
  if (!is_equal) ++check.different_rows;
}

}  // namespace

void compare_with_episode(const Trace& trace, const Episode& episode, int bits, ReplayCheck& check) {
  if (check.edition != trace.edition || trace.rows.size() < check.rows) check = {};
  check.edition = trace.edition;
  const ComparedColumns columns{column_of(episode, kTimestamp), column_of(episode, kTravel),
                                column_of(episode, kTactile)};
  const auto has_rows = [&](const EpisodeColumn* column) {
    return column != nullptr && column->values.size() == static_cast<std::size_t>(episode.rows) * column->width;
  };
  if (!has_rows(columns.time) || !has_rows(columns.travel) || !has_rows(columns.tactile) || columns.time->width != 1 ||
      columns.travel->width != 1) {
    check.problem = "the episode has no times, travels or readings";
    return;
  }
  const auto rows = static_cast<std::size_t>(episode.rows);
  for (; check.rows < trace.rows.size() && check.problem.empty(); ++check.rows) {
    const TraceRow& row = trace.rows[check.rows];
    check.has_preview = check.has_preview || row.quality == SampleQuality::preview;
    if (row.readings.size() != columns.tactile->width)
      check.problem =
          fmt::format("the run has {} readings and the episode has {}", row.readings.size(), columns.tactile->width);
    else if (check.rows < rows)
      compare_row(row, columns, check.rows, bits, check);
    else
      ++check.different_rows;
  }
}

namespace {

constexpr const char *kStudyDensity = "density", *kStudySeed = "seed";
constexpr const char *kScenarioRoot = "/scenario/", *kSamplingRoot = "/layout/sampling/";
constexpr const char* kElsewhere = "open it in the panel Data set";

std::string pointer_of(const std::string& key) {
  return (key == kStudyDensity || key == kStudySeed ? kSamplingRoot : kScenarioRoot) + key;
}

/// One run of the data set: an episode or a failed job.
struct SetRun {
  std::map<std::string, double> numbers;      ///< changed numbers by pointer
  std::map<std::string, std::string> others;  ///< changed values that are no numbers, as JSON
  const EpisodeEntry* episode = nullptr;      ///< episode of the run, or null for a failed job
  std::string error;
};

SetRun run_of(const std::vector<JobChange>& changes) {
  SetRun run;
  for (const JobChange& change : changes) {
    if (const auto number = number_of_json(change.value))
      run.numbers[change.pointer] = *number;
    else
      run.others[change.pointer] = change.value;
  }
  return run;
}

std::vector<SetRun> runs_of_set(const DataSet& set, const DataSetHead& head, const fs::path& folder) {
  std::vector<SetRun> runs;
  for (const EpisodeEntry& entry : set.episodes()) {
    SetRun run = run_of(parse_changes(entry.changes, folder.string(), fmt::format("episode {}", entry.index)));
    run.episode = &entry;
    runs.push_back(std::move(run));
  }
  for (const FailedJob& job : head.failed) {
    SetRun run = run_of(job.changes);
    run.error = job.error;
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Returns the values of each parameter, in ascending order. If more than two values are changed, the parameters are
/// those that vary.
std::map<std::string, std::set<double>> varied_numbers(const std::vector<SetRun>& runs, const fs::path& folder) {
  std::map<std::string, std::set<double>> values;
  for (const SetRun& run : runs) {
    const bool has_same_pointers =
        std::ranges::equal(run.numbers | std::views::keys, runs.front().numbers | std::views::keys);
    if (run.others != runs.front().others || !has_same_pointers)
      throw Error(folder.string(),
                  std::string("is no study: its jobs change several sets of values, or values that are no numbers; ") +
                      kElsewhere);
    for (const auto& [pointer, number] : run.numbers) values[pointer].insert(number);
  }
  if (values.size() > 2) std::erase_if(values, [](const auto& entry) { return entry.second.size() < 2; });
  if (values.empty() || values.size() > 2) {
    std::string names;
    for (const auto& [pointer, numbers] : values) names += (names.empty() ? "" : ", ") + pointer;
    throw Error(folder.string(), fmt::format("is no study: one or two numbers must vary, and {} do{}; {}",
                                             values.size(), names.empty() ? "" : " (" + names + ")", kElsewhere));
  }
  return values;
}

std::string key_of(const std::string& pointer, const Scenario& scenario, const fs::path& folder) {
  for (const char* root : {kScenarioRoot, kSamplingRoot}) {
    if (!pointer.starts_with(root)) continue;
    const std::string key = pointer.substr(std::string(root).size());
    const bool is_of_samples = root == kSamplingRoot && (key == kStudyDensity || key == kStudySeed);
    if (is_of_samples || (root == kScenarioRoot && find_number(scenario, key) != nullptr)) return key;
  }
  throw Error(folder.string(), pointer, std::string("is no parameter of a study; ") + kElsewhere);
}

/// Returns the scenario with the values of a run in place of its own.
Scenario with_values(Scenario scenario, const Study& study, const std::vector<double>& values) {
  for (std::size_t p = 0; p < study.parameters.size(); ++p)
    if (double* number = find_number(scenario, study.parameters[p].key)) *number = values[p];
  return scenario;
}

const std::vector<double>& column(const Episode& episode, const char* name, const fs::path& folder) {
  const auto found = std::ranges::find(episode.columns, name, &EpisodeColumn::name);
  if (found == episode.columns.end()) throw Error(folder.string(), fmt::format("has no column {}", name));
  return found->values;
}

void fill_curve(const Episode& episode, std::size_t taxels, const fs::path& folder, StudyCurve& curve) {
  curve.time = column(episode, kTimestamp, folder);
  const std::vector<double>& tactile = column(episode, kTactile, folder);
  if (curve.time.size() != static_cast<std::size_t>(episode.rows) || tactile.size() != taxels * curve.time.size())
    throw Error(folder.string(), "is damaged: an episode has another number of readings than its layout");
  curve.readings.assign(taxels, {});
  for (std::size_t i = 0; i < tactile.size(); ++i) curve.readings[i % taxels].push_back(tactile[i]);
}

/// Fills the runs of a study from the runs of a data set.
class StudyReader {
 public:
  StudyReader(const DataSet& set, const fs::path& folder) : set_(set), folder_(folder) {}

  StudyCurves read(const DataSetHead& head, Progress& progress) {
    const std::vector<SetRun> runs = runs_of_set(set_, head, folder_);
    if (set_.episodes().empty() || runs.size() > kMostRuns)
      throw Error(folder_.string(), fmt::format("is no study: it has {} runs, and a study 1 to {}; {}", runs.size(),
                                                kMostRuns, kElsewhere));
    begin(runs);
    for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
      progress.check(static_cast<double>(i) / static_cast<double>(curves_.runs.size()));
      fill(run_with(curves_.runs[i].run.values, runs), curves_.runs[i]);
    }
    return std::move(curves_);
  }

 private:
  void begin(const std::vector<SetRun>& runs) {
    curves_.folder = folder_.string();
    const EpisodeEntry& first = set_.episodes().front();
    const EpisodeSensor& sensor = set_.layouts()[first.layout];
    curves_.aggregate = parse_layout(sensor.layout_json, folder_.string()).readout.aggregate;
    curves_.taxel_ids.assign(sensor.taxel_ids.begin(), sensor.taxel_ids.end());
    curves_.study.scenario = parse_scenario(first.scenario, folder_.string());
    for (const auto& [pointer, values] : varied_numbers(runs, folder_)) {
      pointers_.push_back(pointer);
      curves_.study.parameters.push_back(
          {key_of(pointer, curves_.study.scenario, folder_), {values.begin(), values.end()}});
    }
    for (StudyRun& run : runs_of(curves_.study)) curves_.runs.push_back({std::move(run), {}, {}, {}});
  }

  /// Returns the run with these values. Throws Error if there is none or several.
  [[nodiscard]] const SetRun& run_with(const std::vector<double>& values, const std::vector<SetRun>& runs) const {
    const auto has_values = [&](const SetRun& run) {
      for (std::size_t p = 0; p < values.size(); ++p)
        if (run.numbers.at(pointers_[p]) != values[p]) return false;
      return true;
    };
    const auto found = std::ranges::find_if(runs, has_values);
    if (found == runs.end() || std::ranges::count_if(runs, has_values) > 1)
      throw Error(folder_.string(),
                  fmt::format("is no study: {} with {} = {}{}; {}", found == runs.end() ? "no run" : "several runs",
                              pointers_[0], values[0],
                              values.size() > 1 ? fmt::format(", {} = {}", pointers_[1], values[1]) : "", kElsewhere));
    return *found;
  }

  void fill(const SetRun& run, StudyCurve& curve) {
    curve.error = run.error;
    if (run.episode == nullptr) return;
    const EpisodeSensor& sensor = set_.layouts()[run.episode->layout];
    const bool has_same_taxels = std::ranges::equal(sensor.taxel_ids, curves_.taxel_ids);
    const Scenario scenario = parse_scenario(run.episode->scenario, folder_.string());
    if (!has_same_taxels || scenario != with_values(curves_.study.scenario, curves_.study, curve.run.values))
      throw Error(folder_.string(),
                  fmt::format("is no study: {} of episode {} differs in more than the parameters; {}",
                              has_same_taxels ? "the scenario" : "the layout", run.episode->index, kElsewhere));
    fill_curve(set_.read_episode(static_cast<std::size_t>(run.episode->index)), curves_.taxel_ids.size(), folder_,
               curve);
    curves_.longest = std::max(curves_.longest, curve.time.back());
    curves_.largest_reading = std::max(curves_.largest_reading, run.episode->summary.peak);
  }

  const DataSet& set_;
  const fs::path& folder_;
  std::vector<std::string> pointers_;  // parallel to the parameters
  StudyCurves curves_;
};

}  // namespace

std::string job_line_of(const Study& study) {
  std::string scenario = scenario_to_json(study.scenario);
  std::ranges::replace(scenario, '\n', ' ');  // a text of JSON has no line break
  std::string set;
  for (const StudyParameter& parameter : study.parameters) {
    set += fmt::format("{}\"{}\": {{\"values\": [", set.empty() ? "" : ", ", pointer_of(parameter.key));
    for (std::size_t i = 0; i < parameter.values.size(); ++i)
      set += parameter.key == kStudySeed
                 ? fmt::format("{}{}", i > 0 ? ", " : "", static_cast<std::uint64_t>(parameter.values[i]))
                 : fmt::format("{}{}", i > 0 ? ", " : "", parameter.values[i]);
    set += "]}";
  }
  return fmt::format("{{\"scenario\": {}, \"set\": {{{}}}}}\n", scenario, set);
}

StudyCurves read_study_of_data_set(const fs::path& folder, Progress& progress) {
  const DataSetHead head = read_data_set_head(folder);
  const DataSet set(folder);
  return StudyReader(set, folder).read(head, progress);
}

}  // namespace taxel
