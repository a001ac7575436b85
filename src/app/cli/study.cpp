// taxel study: a scenario with several values of one or two parameters, side by side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/played_scenario.h"
#include "app/cli/signals.h"
#include "app/cli/study_report.h"
#include "core/base/output_folder.h"
#include "core/run/recording/csv.h"
#include "core/run/recording/npz.h"
#include "core/sim/study/side_by_side.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string study, layout, out;
  LayoutOptions over;
};

/// Models of one layout, one for each density and seed that is asked for.
class Models {
 public:
  Models(const Options& options, Console& console) : options_(options), console_(console) {}
  SensorModelPtr of(const StudyRun& run) {
    LayoutOptions over = options_.over;
    if (run.density) over.density = run.density;
    if (run.seed) over.seed = run.seed;
    SensorModelPtr& model = models_[{over.density.value_or(0), over.seed}];
    if (!model) model = load_model(options_.layout, over, console_, nullptr, &cache_);
    return model;
  }

 private:
  const Options& options_;
  Console& console_;
  SensorCache cache_;
  std::map<std::pair<double, std::optional<std::uint64_t>>, SensorModelPtr> models_;
};

/// Records the runs of a study and writes the files of each run as soon as it ends.
class RecordedStudy {
 public:
  RecordedStudy(const Study& study, const Options& options, Console& console)
      : study_(study), models_(options, console), console_(console) {
    for (StudyRun& run : runs_of(study)) results_.push_back({std::move(run), {}, {}});
    if (!options.out.empty()) folder_.emplace(options.out);
  }

  /// Makes and records all runs, or those that have ended when a signal is received.
  void record_all() {
    Progress progress;
    run_side_by_side(
        static_cast<int>(results_.size()),
        [&](int i) {
          console_.progress(std::min(0.99, progress.fraction()));
          return make_run(results_[static_cast<std::size_t>(i)]);
        },
        [&](int i, Simulator& simulator) { record_run(simulator, static_cast<std::size_t>(i)); }, progress);
    console_.progress(1);
    if (write_failure_) throw Error(*write_failure_);
  }

  [[nodiscard]] const std::vector<StudyResult>& results() const { return results_; }

  /// Writes the tables of all recorded runs. Returns the names of all files that were written.
  std::vector<std::string> write_tables() {
    if (!folder_) return {};
    folder_->write("study.json", study_to_json(study_));
    folder_->write("summary.csv", study_summary_csv(study_, results_));
    folder_->write("runs.csv", study_runs_csv(study_, results_));
    commit();
    return {files_.begin(), files_.end()};
  }

 private:
  /// Null if the run cannot be made; its result says why.
  std::unique_ptr<Simulator> make_run(StudyResult& result) {
    if (is_interrupted(result)) return nullptr;
    SensorModelPtr model;
    try {
      model = models_.of(result.run);
    } catch (const Cancelled&) {
      is_interrupted(result);
      return nullptr;
    }
    has_warned_ = has_warned_ || warn_of_depth(result.run.scenario, *model, console_);  // of the first such depth
    try {
      return Simulator::make_scenario(model, result.run.scenario);
    } catch (const Error& e) {
      result.error = e.what();
      return nullptr;
    }
  }

  /// The result of a run that fails says why. The other runs continue.
  void record_run(Simulator& simulator, std::size_t index) {
    Console silent(CommonOptions{.quiet = true});
    StudyResult& result = results_[index];
    RunCost cost;
    try {
      Recording recording = record(simulator, 0, silent, cost);
      if (is_interrupted(result)) return;
      result.recording = std::move(recording);
    } catch (const Error& e) {
      result.error = e.what();
      return;
    }
    if (folder_) write_run(index);
  }

  void write_run(std::size_t index) {
    const std::string name = study_run_name(index);
    const std::string csv = recording_to_csv(results_[index].recording);
    const std::string npz = recording_to_npz(results_[index].recording);
    const std::scoped_lock lock(mutex_);
    if (write_failure_) return;
    try {
      folder_->leave_out("summary.csv");  // tables of an older study would be taken for tables of these runs
      folder_->leave_out("runs.csv");
      folder_->write("study.json", study_to_json(study_));
      folder_->write(name + ".csv", csv);
      folder_->write(name + ".npz", npz);
      commit();
    } catch (const Error& e) {
      write_failure_ = e;
    }
  }

  void commit() {
    for (std::string& name : folder_->commit()) files_.insert(std::move(name));
  }

  /// Whether a signal ends the study before the run of `result` has ended.
  static bool is_interrupted(StudyResult& result) {
    if (received_signal() == 0) return false;
    result.error = fmt::format("was ended by {}", name_of_signal(received_signal()));
    return true;
  }

  const Study& study_;
  Models models_;
  Console& console_;
  std::optional<OutputFolder> folder_;
  std::vector<StudyResult> results_;
  bool has_warned_ = false;
  std::mutex mutex_;  // of the members below and folder_
  std::set<std::string> files_;
  std::optional<Error> write_failure_;
};

int run(const Options& options, Console& console) {
  const Study study = read_study(options.study);
  const FinishOnSignal finish;
  RecordedStudy recorded(study, options, console);
  const auto start = std::chrono::steady_clock::now();
  recorded.record_all();
  const std::vector<StudyResult>& results = recorded.results();
  if (std::all_of(results.begin(), results.end(), [](const StudyResult& r) { return !r.error.empty(); })) {
    if (received_signal() == 0) throw Error("no run could be made: " + results.front().error);
    console.warn(fmt::format("no run had ended: {}", results.front().error));
    return FinishOnSignal::exit_status(kDone);
  }
  StudyReport report{
      study, results, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), {}, options.out};
  report.files = recorded.write_tables();
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!results[i].error.empty()) console.warn(fmt::format("{}: {}", study_run_name(i), results[i].error));
  console.result(console.json() ? study_report_json(report) : study_report_text(report));
  return FinishOnSignal::exit_status(kDone);
}

}  // namespace

Command add_study(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      add_command(parent, common, "study",
                  "A scenario with several values of one or two parameters, as many runs at a time as there "
                  "are cores",
                  "taxel study depths.json --layout finger.taxels.json --out result");
  app->add_option("study", options->study, "Study file (docs/project_format.md); what it names is looked for beside it")
      ->required()
      ->type_name("FILE");
  app->add_option("--layout", options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)")
      ->type_name("FILE");
  app->add_option(
         "--out", options->out,
         "Folder for summary.csv (a line per run and taxel), runs.csv, study.json, and per run run_NNN.csv and "
         "run_NNN.npz as `taxel sweep` writes its readings")
      ->type_name("DIR");
  add_skin(*app, options->over.skin);
  add_sampling(*app, options->over);
  add_aggregate(*app, options->over.aggregate);
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
