// taxel study: runs a scenario with several values of one or two parameters.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <ranges>
#include <set>

#include "app/cli/command_layout.h"
#include "app/cli/played_scenario.h"
#include "app/cli/recorder.h"
#include "app/cli/report_writer.h"
#include "app/cli/signals.h"
#include "core/base/output.h"
#include "core/document/scenario/study.h"
#include "core/run/recording/recording.h"
#include "core/run/recording/recording_files.h"
#include "core/sim/study.h"

namespace taxel::cli {
namespace {

struct StudyOptions {
  std::string study, layout, out;
  LayoutOptions over;
};

struct StudyResult {
  StudyRun run;
  Recording recording;
  std::string error;  ///< why the run failed, or empty

  [[nodiscard]] RecordedSensorSummary summary() const { return summarize(recording).front(); }
};

/// Returns the name of a run and of its files, such as "run_007".
std::string study_run_name(std::size_t run) {
  return fmt::format("run_{:03}", run);
}

struct StudyReport {
  const Study& study;
  const std::vector<StudyResult>& results;
  double wall = 0;                 ///< wall time of all runs [s]
  std::vector<std::string> files;  ///< names of the written files; empty without --out
  std::string folder;

  void visit_run(ReportWriter& w, std::size_t i) const {
    const StudyResult& result = results[i];
    w("name", study_run_name(i));
    w("values", result.run.values);
    if (!result.error.empty()) return w("error", result.error);
    const RecordedSensorSummary summary = result.summary();
    w("rows", result.recording.rows.size());
    w("largest_force", summary.largest_force);
    w.list("taxels", summary.taxels, [](ReportWriter& one, const TaxelSummary& taxel) {
      one("id", taxel.id);
      one("peak", taxel.peak);
      one("mean", taxel.mean);
      one("largest_step", taxel.largest_step);
      one("responds", taxel.responds);
    });
  }
  void visit(ReportWriter& w) const {
    w.keys_of(study_to_json(study));
    w.list("runs", std::views::iota(std::size_t{0}, results.size()),
           [&](ReportWriter& run, std::size_t i) { visit_run(run, i); });
    w("wall_seconds", wall);
    w("files", files);
  }
  [[nodiscard]] std::string text() const;
};

std::string StudyReport::text() const {
  std::string text = fmt::format("{} runs of a {}\n", results.size(), to_word(study.scenario.kind()));
  std::string head = fmt::format("{:<8}", "run");
  for (const StudyParameter& parameter : study.parameters) head += fmt::format(" {:>14}", parameter.key);
  text += head + fmt::format(" {:>6} {:>14} {:>12} {:>14}\n", "taxel", "highest peak", "force [N]", "largest step");
  for (std::size_t i = 0; i < results.size(); ++i) {
    text += fmt::format("{:<8}", study_run_name(i));
    for (const double value : results[i].run.values) text += fmt::format(" {:>14.6g}", value);
    if (!results[i].error.empty()) {
      text += "  failed\n";
      continue;
    }
    const RecordedSensorSummary summary = results[i].summary();
    const TaxelSummary* highest = &summary.taxels.front();
    double step = 0;
    for (const TaxelSummary& taxel : summary.taxels) {
      if (taxel.peak > highest->peak) highest = &taxel;
      if (taxel.responds) step = std::max(step, taxel.largest_step);
    }
    text += fmt::format(" {:>6} {:>14.6g} {:>12.4g} {:>12.2f} %\n", highest->id, highest->peak, summary.largest_force,
                        100 * step);
  }
  text += fmt::format("{:.2f} s\n", wall);
  if (!files.empty()) text += fmt::format("wrote {}: {} files\n", folder, files.size());
  return text;
}

/// Returns the keys of the parameters, a comma before each.
std::string head_of(const Study& study) {
  std::string head;
  for (const StudyParameter& parameter : study.parameters) head += "," + parameter.key;
  return head;
}

/// Returns the values of the parameters in a run, a comma before each.
std::string values_of(const StudyRun& run) {
  std::string text;
  for (const double value : run.values) text += fmt::format(",{}", value);
  return text;
}

/// Returns a line for each taxel of each run: `run,PARAMETER...,taxel,peak,mean,largest_step`. The mean is over the
/// rows, largest_step is a fraction of the taxel's own peak. Failed runs have no lines.
std::string study_summary_csv(const Study& study, const std::vector<StudyResult>& results) {
  std::string csv = "run" + head_of(study) + ",taxel,peak,mean,largest_step\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].error.empty()) continue;
    const RecordedSensorSummary summary = results[i].summary();
    for (const TaxelSummary& taxel : summary.taxels)
      csv += fmt::format("{}{},{},{},{},{}\n", i, values_of(results[i].run), taxel.id, taxel.peak, taxel.mean,
                         taxel.largest_step);
  }
  return csv;
}

/// Returns a line for each run that did not fail: `file,PARAMETER...`, for plots.
std::string study_runs_csv(const Study& study, const std::vector<StudyResult>& results) {
  std::string csv = "file" + head_of(study) + "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].error.empty()) csv += study_run_name(i) + ".csv" + values_of(results[i].run) + "\n";
  return csv;
}

/// Models of one layout, one for each density and seed of the runs.
class Models {
 public:
  Models(const StudyOptions& options, Console& console) : options_(options), console_(console) {}
  SensorModelPtr of(const StudyRun& run) {
    LayoutOptions over = options_.over;
    if (run.density) over.density = run.density;
    if (run.seed) over.seed = run.seed;
    SensorModelPtr& model = models_[{over.density.value_or(0), over.seed}];
    if (!model) model = load_model(options_.layout, over, console_, nullptr, &cache_);
    return model;
  }

 private:
  const StudyOptions& options_;
  Console& console_;
  SensorCache cache_;
  std::map<std::pair<double, std::optional<std::uint64_t>>, SensorModelPtr> models_;
};

/// Records the runs of a study and writes the files of each run as soon as it ends.
class RecordedStudy {
 public:
  RecordedStudy(const Study& study, const StudyOptions& options, Console& console)
      : study_(study), runs_(runs_of(study)), models_(options, console), console_(console), recorders_(runs_.size()) {
    for (const StudyRun& run : runs_) results_.push_back({run, {}, {}});
    if (!options.out.empty()) folder_.emplace(options.out);
  }

  /// Makes and records all runs, or those that have ended when a signal is received.
  void record_all() {
    Progress progress;
    const auto model = [&](std::size_t i) {
      console_.progress(std::min(0.99, progress.fraction()));
      return make_model(results_[i]);
    };
    run_study(
        runs_, model, [&](std::size_t i, const Simulator& simulator) { return record_step(simulator, i); },
        [&](std::size_t i, const std::string& error) { end_run(i, error); }, progress);
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
  /// Returns the model of a run, or null if a signal was received. Then the result contains the error.
  SensorModelPtr make_model(StudyResult& result) {
    if (is_interrupted(result)) return nullptr;
    try {
      SensorModelPtr model = models_.of(result.run);
      has_warned_ = has_warned_ || warn_of_depth(result.run.scenario, *model, console_);  // only for the first depth
      return model;
    } catch (const Cancelled&) {
      is_interrupted(result);
      return nullptr;
    }
  }

  /// Returns false if a signal was received.
  bool record_step(const Simulator& simulator, std::size_t index) {
    Console silent(CommonOptions{.quiet = true});
    std::unique_ptr<CheckedRecorder>& recorder = recorders_[index];
    if (!recorder) recorder = std::make_unique<CheckedRecorder>(*simulator.scene(), 0, silent);
    recorder->follow(simulator);
    return received_signal() == 0;
  }

  void end_run(std::size_t index, const std::string& error) {
    StudyResult& result = results_[index];
    const std::unique_ptr<CheckedRecorder> recorder = std::move(recorders_[index]);
    result.error = error;
    if (!error.empty() || is_interrupted(result)) return;
    result.recording = recorder->take();
    if (folder_) write_run(index);
  }

  void write_run(std::size_t index) {
    const std::string name = study_run_name(index);
    const std::string csv = recording_to_csv(results_[index].recording);
    const std::string npz = recording_to_npz(results_[index].recording);
    const std::scoped_lock lock(mutex_);
    if (write_failure_) return;
    try {
      folder_->leave_out("summary.csv");  // removes tables of an older study
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

  /// Returns whether a signal has ended the study, and records it as the error of `result`.
  static bool is_interrupted(StudyResult& result) {
    if (received_signal() == 0) return false;
    result.error = fmt::format("was ended by {}", name_of_signal(received_signal()));
    return true;
  }

  const Study& study_;
  std::vector<StudyRun> runs_;
  Models models_;
  Console& console_;
  std::optional<OutputFolder> folder_;
  std::vector<StudyResult> results_;
  std::vector<std::unique_ptr<CheckedRecorder>> recorders_;  // of the runs that have begun and not ended
  bool has_warned_ = false;
  std::mutex mutex_;  // guards the members below and folder_
  std::set<std::string> files_;
  std::optional<Error> write_failure_;
};

int run_study_command(const StudyOptions& options, Console& console) {
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
  int status = kDone;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].error.empty()) continue;
    console.warn(fmt::format("{}: {}", study_run_name(i), results[i].error));
    status = kProblemsFound;
  }
  print_report(console, report);
  return FinishOnSignal::exit_status(status);
}

}  // namespace

Run add_study(OptionList& list) {
  const auto options = std::make_shared<StudyOptions>();
  list.add("study", &options->study,
           "Study file (docs/project_format.md); relative file names in it are relative to its folder",
           {.unit = "FILE", .is_required = true});
  list.add("--layout", &options->layout, "Layout file (*.taxels.json; default: the built-in fingertip)",
           {.unit = "FILE"});
  list.add("--out", &options->out,
           "Folder for summary.csv (a line per run and taxel), runs.csv, study.json, and per run run_NNN.csv and "
           "run_NNN.npz as `taxel sweep` writes its readings",
           {.unit = "DIR"});
  add_skin(list, options->over.skin);
  add_sampling(list, options->over);
  add_readout(list, options->over.readout);
  return [options](Console& console) { return run_study_command(*options, console); };
}

}  // namespace taxel::cli
