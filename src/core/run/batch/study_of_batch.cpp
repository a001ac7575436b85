#include "core/run/batch/study_of_batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/file/layout_json.h"
#include "core/run/batch/batch_index.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr const char *kStudyDensity = "density", *kStudySeed = "seed";
constexpr const char *kScenarioRoot = "/scenario/", *kSamplingRoot = "/layout/sampling/";

std::string pointer_of(const std::string& key) {
  return (key == kStudyDensity || key == kStudySeed ? kSamplingRoot : kScenarioRoot) + key;
}

/// One run of the batch: an episode or a failed job.
struct BatchRun {
  std::map<std::string, double> numbers;      ///< changed numbers by pointer
  std::map<std::string, std::string> others;  ///< changed values that are no numbers, as JSON
  const EpisodeEntry* episode = nullptr;      ///< episode of the run, or null for a failed job
  std::string error;
};

BatchRun run_of(const std::vector<JobChange>& changes) {
  BatchRun run;
  for (const JobChange& change : changes) {
    if (const auto number = number_of_json(change.value))
      run.numbers[change.pointer] = *number;
    else
      run.others[change.pointer] = change.value;
  }
  return run;
}

std::vector<BatchRun> runs_of_batch(const BatchIndex& batch) {
  std::vector<BatchRun> runs;
  for (const EpisodeEntry& entry : batch.episodes) {
    runs.push_back(run_of(entry.changes));
    runs.back().episode = &entry;
  }
  for (const FailedJob& job : batch.failed) {
    runs.push_back(run_of(job.changes));
    runs.back().error = job.error;
  }
  return runs;
}

/// Returns the values of each parameter, in ascending order. If more than two values are changed, the parameters are
/// those that vary.
std::map<std::string, std::set<double>> varied_numbers(const std::vector<BatchRun>& runs, const fs::path& folder) {
  std::map<std::string, std::set<double>> values;
  for (const BatchRun& run : runs) {
    const bool has_same_pointers =
        std::ranges::equal(run.numbers | std::views::keys, runs.front().numbers | std::views::keys);
    if (run.others != runs.front().others || !has_same_pointers)
      throw Error(folder.string(),
                  "is no study: its jobs change several sets of values, or values that are no numbers");
    for (const auto& [pointer, number] : run.numbers) values[pointer].insert(number);
  }
  if (values.size() > 2) std::erase_if(values, [](const auto& entry) { return entry.second.size() < 2; });
  if (values.empty() || values.size() > 2) {
    std::string names;
    for (const auto& [pointer, numbers] : values) names += (names.empty() ? "" : ", ") + pointer;
    throw Error(folder.string(), fmt::format("is no study: one or two numbers must vary, and {} do{}", values.size(),
                                             names.empty() ? "" : " (" + names + ")"));
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
  throw Error(folder.string(), pointer, "is no parameter of a study");
}

/// Returns the scenario with the values of a run in place of its own.
Scenario with_values(Scenario scenario, const Study& study, const std::vector<double>& values) {
  for (std::size_t p = 0; p < study.parameters.size(); ++p)
    if (double* number = find_number(scenario, study.parameters[p].key)) *number = values[p];
  return scenario;
}

/// Fills the runs of a study from those of a batch.
class StudyReader {
 public:
  StudyReader(const BatchIndex& batch, const fs::path& folder) : batch_(batch), folder_(folder) {}

  StudyCurves read(Progress& progress) {
    const std::vector<BatchRun> runs = runs_of_batch(batch_);
    if (batch_.episodes.empty() || runs.size() > kMostRuns)
      throw Error(folder_.string(),
                  fmt::format("is no study: it has {} runs, and a study 1 to {}", runs.size(), kMostRuns));
    begin(runs);
    for (std::size_t i = 0; i < curves_.runs.size(); ++i) {
      progress.check(static_cast<double>(i) / static_cast<double>(curves_.runs.size()));
      fill(run_with(curves_.runs[i].run.values, runs), curves_.runs[i]);
    }
    return std::move(curves_);
  }

 private:
  void begin(const std::vector<BatchRun>& runs) {
    curves_.folder = folder_.string();
    const EpisodeEntry& first = batch_.episodes.front();
    const EpisodeSensor& sensor = batch_.layouts[first.layout];
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
  [[nodiscard]] const BatchRun& run_with(const std::vector<double>& values, const std::vector<BatchRun>& runs) const {
    const auto has_values = [&](const BatchRun& run) {
      for (std::size_t p = 0; p < values.size(); ++p)
        if (run.numbers.at(pointers_[p]) != values[p]) return false;
      return true;
    };
    const auto found = std::ranges::find_if(runs, has_values);
    if (found == runs.end() || std::ranges::count_if(runs, has_values) > 1)
      throw Error(
          folder_.string(),
          fmt::format("is no study: {} with {} = {}{}", found == runs.end() ? "no run" : "several runs", pointers_[0],
                      values[0], values.size() > 1 ? fmt::format(", {} = {}", pointers_[1], values[1]) : ""));
    return *found;
  }

  void fill(const BatchRun& run, StudyCurve& curve) {
    curve.error = run.error;
    if (run.episode == nullptr) return;
    const EpisodeSensor& sensor = batch_.layouts[run.episode->layout];
    const bool has_same_taxels = std::ranges::equal(sensor.taxel_ids, curves_.taxel_ids);
    const Scenario scenario = parse_scenario(run.episode->scenario, folder_.string());
    if (!has_same_taxels || scenario != with_values(curves_.study.scenario, curves_.study, curve.run.values))
      throw Error(folder_.string(), fmt::format("is no study: {} of episode {} differs in more than the parameters",
                                                has_same_taxels ? "the scenario" : "the layout", run.episode->index));
    fill_curve(*run.episode, curve);
    curves_.longest = std::max(curves_.longest, curve.time.back());
    curves_.largest_reading = std::max(curves_.largest_reading, run.episode->summary.peak);
  }

  void fill_curve(const EpisodeEntry& entry, StudyCurve& curve) {
    const fs::path path = folder_ / entry.shard;
    if (!shard_ || shard_->file() != path.string()) shard_.emplace(path);
    EpisodeColumn time = shard_->rows(kTimestamp, entry.first_row, entry.rows);
    if (time.width != 1) throw Error(shard_->file(), kTimestamp, "is damaged: it must have one number in each row");
    curve.time = std::move(time.values);
    const EpisodeColumn tactile = shard_->rows(kTactile, entry.first_row, entry.rows);
    const std::size_t taxels = curves_.taxel_ids.size();
    if (tactile.width != taxels)
      throw Error(shard_->file(), kTactile, "is damaged: it has another number of readings than its layout");
    curve.readings.assign(taxels, {});
    for (std::size_t i = 0; i < tactile.values.size(); ++i) curve.readings[i % taxels].push_back(tactile.values[i]);
  }

  const BatchIndex& batch_;
  const fs::path& folder_;
  std::optional<Shard> shard_;         // the one that was read last
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

StudyCurves read_study_of_batch(const fs::path& folder, Progress& progress) {
  const BatchIndex batch = read_batch_index(folder);
  return StudyReader(batch, folder).read(progress);
}

}  // namespace taxel
