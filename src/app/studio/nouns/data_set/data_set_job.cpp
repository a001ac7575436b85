// Reads data sets and the rows of their episodes on workers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"
#include "core/run/batch/data_set.h"
#include "core/run/batch/data_set_meta.h"
#include "ui/widgets/format.h"

namespace taxel::studio {
namespace {

class DataSetJob {
 public:
  explicit DataSetJob(JobExecutor& executor);

  /// Requests the data set and the rows of an episode, unless they were requested before.
  void request(const std::optional<ui::DataSetRequest>& set, const std::optional<ui::EpisodeRequest>& episode);
  /// Takes the newest results. Returns whether one of them is new.
  bool update();
  [[nodiscard]] bool busy() const { return sets_.busy() || episodes_.busy(); }
  [[nodiscard]] bool is_reading_set() const { return sets_.busy(); }
  /// The data set that was read last, or null. A data set that cannot be read has a problem and a folder only.
  [[nodiscard]] const ui::OpenDataSetPtr& set() const { return set_; }
  [[nodiscard]] const ui::EpisodeCurvesPtr& curves() const { return curves_; }

 private:
  NewestWins<ui::DataSetRequest, ui::OpenDataSet> sets_;
  NewestWins<ui::EpisodeRequest, ui::EpisodeCurves> episodes_;
  ui::OpenDataSetPtr set_;
  ui::EpisodeCurvesPtr curves_;
};

namespace fs = std::filesystem;

constexpr const char *kScenarioRoot = "/scenario/", *kLayoutRoot = "/layout/";
constexpr const char* kEpisodesTable = "meta/episodes/chunk-000/file-000.parquet";

/// A value of a layout that batches often change, as the window displays it.
struct LayoutValue {
  std::string_view key;
  const char* title;
  int decimal = 0;  ///< the displayed unit is 10^decimal SI units
};
constexpr std::array kLayoutValues{
    LayoutValue{"sampling/density", "Density (1/mm\u00b2)", 6}, LayoutValue{"sampling/seed", "Samples' seed"},
    LayoutValue{"material/modulus", "Modulus (kPa)", 3},        LayoutValue{"material/thickness", "Thickness (mm)", -3},
    LayoutValue{"material/dissipation", "Dissipation (s/m)"},   LayoutValue{"material/friction", "Friction"}};

std::vector<ui::DataSetLayout> layouts_of(const DataSet& set, const fs::path& folder) {
  std::map<std::string, int> counts;
  std::vector<ui::DataSetLayout> layouts;
  for (std::size_t i = 0; i < set.layouts().size(); ++i) {
    const EpisodeSensor& sensor = set.layouts()[i];
    const std::string name = fmt::format("{}: layout {}", (folder / "meta/layouts.parquet").string(), i);
    const Layout layout = parse_layout(sensor.layout_json, name);
    const std::string title = sensor.layout_name.empty() ? "layout" : sensor.layout_name;
    const int count = ++counts[title];
    layouts.push_back(
        {count > 1 ? fmt::format("{} ({})", title, count) : title, layout.readout.aggregate, sensor.taxel_ids});
  }
  return layouts;
}

/// The columns of the changed parameters, which grow while the rows are read.
class Parameters {
 public:
  explicit Parameters(ui::OpenDataSet& set) : set_(set) {}

  /// Adds the values of a job. `scenario` gives labels and units; null for a failed job.
  void add(const std::vector<JobChange>& changes, const Scenario* scenario, ui::EpisodeRow& row) {
    for (const JobChange& change : changes) {
      const std::size_t column = column_of(change.pointer, scenario);
      if (row.values.size() <= column) row.values.resize(column + 1);
      row.values[column] = {change.value, number_of_json(change.value)};
    }
  }
  /// Converts all values to the units of their columns.
  void finish() {
    for (ui::EpisodeRow& row : set_.rows) {
      row.values.resize(set_.parameters.size());
      for (std::size_t i = 0; i < row.values.size(); ++i) show(row.values[i], set_.parameters[i].decimal);
    }
  }

 private:
  std::size_t column_of(const std::string& pointer, const Scenario* scenario) {
    const auto [entry, is_new] = columns_.try_emplace(pointer, set_.parameters.size());
    if (is_new) set_.parameters.push_back({pointer, "", 0});
    ui::DataSetParameter& parameter = set_.parameters[entry->second];
    if (parameter.title.empty() || has_plain_title(parameter)) name_parameter(scenario, parameter);
    return entry->second;
  }
  static bool has_plain_title(const ui::DataSetParameter& parameter) {
    return parameter.pointer.starts_with(kScenarioRoot) && parameter.pointer.ends_with("/" + parameter.title);
  }
  static void name_parameter(const Scenario* scenario, ui::DataSetParameter& parameter) {
    const std::string& pointer = parameter.pointer;
    const bool is_scenario = pointer.starts_with(kScenarioRoot);
    const std::string root = is_scenario ? kScenarioRoot : kLayoutRoot;
    const std::string key = pointer.starts_with(root) ? pointer.substr(root.size()) : pointer;
    parameter.title = key;
    for (const LayoutValue& entry : kLayoutValues) {
      if (is_scenario || key != entry.key) continue;
      parameter.title = entry.title;
      parameter.decimal = entry.decimal;
    }
    if (scenario == nullptr || !is_scenario) return;
    visit_fields(*scenario, [&](const FieldSpec& field, const auto& /*value*/) {
      if (key != field.key) return;
      parameter.title = label_with_unit(field);
      parameter.decimal = display_unit(field.quantity).decimal;
    });
  }
  static void show(ui::ParameterValue& value, int decimal) {
    if (!value.number) return;
    value.number = ui::shifted_decimal(*value.number, -decimal);
    value.text = fmt::format("{:.6g}", *value.number);
  }

  ui::OpenDataSet& set_;
  std::map<std::string, std::size_t> columns_;
};

ui::EpisodeRow row_of(const EpisodeEntry& entry, const Scenario& scenario) {
  ui::EpisodeRow row;
  row.episode = entry.index;
  row.layout = entry.layout;
  row.line = entry.line;
  row.scenario = std::string(to_word(scenario.kind()));
  row.seed = entry.seed;
  row.peak = entry.summary.peak;
  row.peak_taxel = entry.summary.peak_taxel;
  row.force = entry.summary.largest_force;
  row.rows = entry.rows;
  row.duration = entry.summary.duration;
  return row;
}

void add_episodes(const DataSet& set, const std::string& table, Parameters& parameters, ui::OpenDataSet& open,
                  Progress& progress) {
  constexpr std::size_t kBetweenChecks = 256;
  for (std::size_t i = 0; i < set.episodes().size(); ++i) {
    if (i % kBetweenChecks == 0) progress.check(static_cast<double>(i) / static_cast<double>(set.episodes().size()));
    const EpisodeEntry& entry = set.episodes()[i];
    const std::string where = fmt::format("row {}", i);
    const Scenario scenario = parse_scenario(entry.scenario, table + ": " + where);
    ui::EpisodeRow row = row_of(entry, scenario);
    parameters.add(parse_changes(entry.changes, table, where), &scenario, row);
    open.rows.push_back(std::move(row));
  }
}

/// Reads everything but the rows of the episodes. Throws Error naming the file and the remedy: the data set is missing,
/// damaged, or of a newer version; throws Cancelled.
ui::OpenDataSet read_open_data_set(const std::string& folder, Progress& progress) {
  const fs::path path(folder);
  const DataSetHead head = read_data_set_head(path);
  const auto source = std::make_shared<const DataSet>(path);
  const DataSet& set = *source;
  if (static_cast<std::int64_t>(set.episodes().size()) != head.episodes)
    throw Error((path / kDataSetHeadFile).string(), "/episodes",
                fmt::format("is {}, but {} has {} rows: copy the data set again, with all its files", head.episodes,
                            kEpisodesTable, set.episodes().size()));
  ui::OpenDataSet open;
  open.folder = folder;
  open.program = head.program;
  open.bits = head.bits;
  open.layouts = layouts_of(set, path);
  open.failed = head.failed.size();
  open.broken = head.broken.size();
  Parameters parameters(open);
  add_episodes(set, (path / kEpisodesTable).string(), parameters, open, progress);
  for (const FailedJob& job : head.failed) {
    ui::EpisodeRow row;
    row.line = job.line;
    row.error = job.error;
    parameters.add(job.changes, nullptr, row);
    open.rows.push_back(std::move(row));
  }
  parameters.finish();
  open.source = source;
  return open;
}

void read_set(const ui::DataSetRequest& request, ui::OpenDataSet& set, Progress& progress) {
  set.folder = request.folder;
  set = read_open_data_set(request.folder, progress);
}

const std::vector<double>& values_of(const Episode& episode, const char* name) {
  const auto found = std::ranges::find(episode.columns, name, &EpisodeColumn::name);
  if (found == episode.columns.end()) throw Error(fmt::format("the episode has no column {}", name));
  return found->values;
}

/// Returns a column of lists as a trace.
Trace trace_of(const Episode& episode, const char* name, std::uint64_t edition) {
  const std::vector<double>&time = values_of(episode, kTimestamp), &travel = values_of(episode, kTravel),
        &values = values_of(episode, name);
  const auto rows = static_cast<std::size_t>(episode.rows);
  if (time.size() != rows || travel.size() != rows)
    throw Error("the episode is damaged: it has another number of times or travels than rows");
  const std::size_t width = values.size() / rows;
  Trace trace{{}, edition};
  for (std::size_t r = 0; r < rows; ++r) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(r * width);
    trace.rows.push_back({time[r], travel[r], {first, first + static_cast<std::ptrdiff_t>(width)}});
  }
  return trace;
}

/// Reads the rows of one episode: one row group of one file.
void read_rows(const ui::EpisodeRequest& request, ui::EpisodeCurves& curves, Progress& /*progress*/) {
  curves.from = request.choice;
  const Episode episode = request.source->read_episode(static_cast<std::size_t>(request.choice.episode));
  const auto edition = static_cast<std::uint64_t>(request.choice.episode) + 1;
  curves.readings = trace_of(episode, kTactile, edition);
  curves.forces = trace_of(episode, kContactForce, edition);
}

}  // namespace

DataSetJob::DataSetJob(JobExecutor& executor)
    : sets_(executor, Priority::background, read_set), episodes_(executor, Priority::background, read_rows) {}

void DataSetJob::request(const std::optional<ui::DataSetRequest>& set,
                         const std::optional<ui::EpisodeRequest>& episode) {
  if (set) sets_.post(*set, Superseded::cancel);
  if (episode) episodes_.post(*episode, Superseded::cancel);
}

bool DataSetJob::update() {
  const ui::OpenDataSetPtr set = sets_.newest();
  const ui::EpisodeCurvesPtr curves = episodes_.newest();
  const bool is_new = set != set_ || curves != curves_;
  set_ = set;
  curves_ = curves;
  return is_new;
}

namespace {

class DataSetOfFeature final : public FeatureJob {
 public:
  explicit DataSetOfFeature(JobExecutor& executor) : job_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    job_.request(app.get<ui::DataSetState>().request, ui::episode_request(app.get<ui::DataSetState>()));
  }
  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& /*run*/,
                      const SendToSimulation& /*send*/) override {
    return job_.update();
  }
  void report(HostEvents& events) override {
    const ui::OpenDataSetPtr& set = job_.set();
    if (!store(reported_, set) || !set) return;
    if (!set->problem.empty()) events.emplace_back(HostMessage{Severity::error, set->problem});
    events.emplace_back(DataSetRead{set->folder, set->problem.empty()});
  }
  void fill(ui::App& app) const override {
    ui::show_data_set(app.get<ui::DataSetState>(), job_.set(), job_.curves());
    app.get<ui::DataSetState>().is_reading = job_.is_reading_set();
  }
  [[nodiscard]] bool busy() const override { return job_.busy(); }

 private:
  DataSetJob job_;
  ui::OpenDataSetPtr reported_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_data_set_job(JobExecutor& executor) {
  return std::make_unique<DataSetOfFeature>(executor);
}

}  // namespace taxel::studio
