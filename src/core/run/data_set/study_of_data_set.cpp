#include "core/run/data_set/study_of_data_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ranges>
#include <set>

#include "core/base/error.h"
#include "core/document/scenario/scenario_json.h"
#include "core/layout/file/layout_json.h"
#include "core/run/batch/data_set.h"
#include "core/run/data_set/data_set_head.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

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
