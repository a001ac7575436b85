// taxel study: a scenario with several values of one or two parameters, side by side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/study_report.h"
#include "core/base/output_folder.h"
#include "core/project/recording/csv.h"
#include "core/project/recording/npz.h"
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

/// A run that fails is told in its result; the others go on.
void record_run(Simulator& simulator, StudyResult& result) {
  Console silent(CommonOptions{.quiet = true});
  RunCost cost;
  try {
    result.recording = record(simulator, 0, silent, cost);
  } catch (const Error& e) {
    result.error = e.what();
  }
}

/// Null where the run cannot be made, which is told in its result.
std::unique_ptr<Simulator> make_run(Models& models, StudyResult& result) {
  const SensorModelPtr model = models.of(result.run);
  try {
    return Simulator::make_scenario(model, result.run.scenario);
  } catch (const Error& e) {
    result.error = e.what();
    return nullptr;
  }
}

void write(OutputFolder& folder, const Study& study, const std::vector<StudyResult>& results) {
  folder.write("study.json", study_to_json(study));
  folder.write("summary.csv", study_summary_csv(study, results));
  folder.write("runs.csv", study_runs_csv(study, results));
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].error.empty()) continue;
    folder.write(study_run_name(i) + ".csv", recording_to_csv(results[i].recording));
    folder.write(study_run_name(i) + ".npz", recording_to_npz(results[i].recording));
  }
}

int run(const Options& options, Console& console) {
  const Study study = read_study(options.study);
  const std::vector<StudyRun> runs = runs_of(study);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  Models models(options, console);
  std::vector<StudyResult> results(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) results[i].run = runs[i];
  const auto start = std::chrono::steady_clock::now();
  Progress progress;
  run_side_by_side(
      static_cast<int>(runs.size()),
      [&](int i) {
        console.progress(std::min(0.99, progress.fraction()));
        return make_run(models, results[static_cast<std::size_t>(i)]);
      },
      [&](int i, Simulator& simulator) { record_run(simulator, results[static_cast<std::size_t>(i)]); }, progress);
  console.progress(1);
  if (std::all_of(results.begin(), results.end(), [](const StudyResult& r) { return !r.error.empty(); }))
    throw Error("no run could be made: " + results.front().error);
  StudyReport report{
      study, results, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), {}, options.out};
  if (folder) {
    write(*folder, study, results);
    report.files = folder->commit();
  }
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!results[i].error.empty()) console.warn(fmt::format("{}: {}", study_run_name(i), results[i].error));
  console.result(console.json() ? study_report_json(report) : study_report_text(report));
  return kDone;
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
