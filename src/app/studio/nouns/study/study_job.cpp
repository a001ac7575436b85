// Runs parameter studies, or reads them from batches, on a worker, and writes the displayed one as a batch on another.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/version/version.h"
#include "core/base/text/message.h"
#include "core/run/batch/study_of_batch.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/study.h"

namespace taxel::studio {
namespace {

struct StudyInput {
  ui::StudyRequest request;
  SensorModelPtr model;  ///< model of the studied layout; may be null if the study is read
  bool operator==(const StudyInput& other) const { return request == other.request; }
};

class StudyJob : public NewestWins<StudyInput, StudyCurves> {
 public:
  explicit StudyJob(JobExecutor& executor);

  /// Runs a study of the layout of `model`, or reads a study from its folder, which needs no model. Without a request
  /// the study is cancelled.
  void request(const std::optional<ui::StudyRequest>& request, const SensorModelPtr& model);
};

/// The writing of a study as a batch.
struct StudySave {
  ui::StudySaveRequest request;
  StudyInput input;  ///< the study that is displayed
  bool operator==(const StudySave& other) const { return request == other.request; }
};

struct SavedStudy {
  std::string folder;
  std::string text;     ///< a sentence for the user
  std::string problem;  ///< why the batch was not written, or empty
};

class StudySaver : public NewestWins<StudySave, SavedStudy> {
 public:
  explicit StudySaver(JobExecutor& executor);

  /// Begins to write `input`, unless that was requested before. Without a request the writing is cancelled.
  void request(const std::optional<ui::StudySaveRequest>& request, const std::optional<StudyInput>& input);
};

/// Builds the sensor with the samples that a run requests.
SensorModelPtr model_of(const StudyRun& run, const SensorModelPtr& model, SensorCache& cache, Progress& progress) {
  if (!run.density && !run.seed) return model;
  Layout layout = model->layout;
  layout.sampling.density = run.density.value_or(layout.sampling.density);
  layout.sampling.seed = run.seed.value_or(layout.sampling.seed);
  SensorBuild how;
  how.cache = &cache;
  progress.stop_if_cancelled();
  return build_sensor_model(layout, model->loaded, "", layout.name, how);
}

void append_row(StudyCurve& curve, const Simulator& simulator) {
  const StepView step = simulator.view();
  const std::span<const double> readings = step.sensors.front().readings;
  curve.time.push_back(step.time);
  curve.readings.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) curve.readings[k].push_back(readings[k]);
}

void fill_curves(const StudyInput& input, StudyCurves& curves, Progress& progress) {
  if (!input.request.folder.empty()) {
    curves.folder = input.request.folder;  // also if the study cannot be read
    curves = read_study_of_batch(input.request.folder, progress);
    return;
  }
  curves.study = input.request.study;
  curves.aggregate = input.model->layout.readout.aggregate;
  for (const Taxel& taxel : input.model->layout.taxels) curves.taxel_ids.push_back(taxel.id);
  const std::vector<StudyRun> runs = runs_of(curves.study);
  for (const StudyRun& run : runs) curves.runs.push_back({run, {}, {}, {}});
  SensorCache cache;
  const auto step = [&](std::size_t run, const Simulator& simulator) {
    if (simulator.row_due()) append_row(curves.runs[run], simulator);
    return true;
  };
  const auto end = [&](std::size_t run, const std::string& error) { curves.runs[run].error = error; };
  run_study(
      runs, [&](std::size_t run) { return model_of(runs[run], input.model, cache, progress); }, step, end, progress);
  const auto failed = [](const StudyCurve& curve) { return !curve.error.empty() && curve.time.empty(); };
  if (std::all_of(curves.runs.begin(), curves.runs.end(), failed))
    curves.problem = taxel::shown_part(curves.runs.front().error);
  for (const StudyCurve& curve : curves.runs) {
    if (!curve.time.empty()) curves.longest = std::max(curves.longest, curve.time.back());
    for (const std::vector<double>& readings : curve.readings)
      for (const double reading : readings) curves.largest_reading = std::max(curves.largest_reading, reading);
  }
}

}  // namespace

StudyJob::StudyJob(JobExecutor& executor) : NewestWins(executor, Priority::background, fill_curves) {}

void StudyJob::request(const std::optional<ui::StudyRequest>& request, const SensorModelPtr& model) {
  if (!request) return post(std::nullopt, Superseded::cancel);
  if (model || !request->folder.empty()) post(StudyInput{*request, model}, Superseded::cancel);
}

namespace {

void write_study(const StudySave& save, SavedStudy& saved, Progress& progress) {
  saved.folder = save.request.folder;
  const BatchCounts counts =
      save_study({save.input.request.study, save.input.model, save.request.folder, version_line("taxel")}, progress);
  saved.text = fmt::format("Wrote {} runs as a batch: {}", counts.episodes, save.request.folder);
  if (!counts.failed.empty()) saved.text += fmt::format(" ({} runs failed)", counts.failed.size());
}

}  // namespace

StudySaver::StudySaver(JobExecutor& executor) : NewestWins(executor, Priority::background, write_study) {}

void StudySaver::request(const std::optional<ui::StudySaveRequest>& request, const std::optional<StudyInput>& input) {
  if (!request) return post(std::nullopt, Superseded::cancel);
  const std::optional<StudySave> last = posted();
  if ((last && last->request == *request) || !input) return;
  post(StudySave{*request, *input}, Superseded::cancel);
}

namespace {

class StudyOfFeature final : public FeatureJob {
 public:
  explicit StudyOfFeature(JobExecutor& executor) : study_(executor), saver_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& /*send*/) override {
    study_.request(app.get<ui::StudyState>().request, model);
    saver_.request(app.get<ui::StudyState>().save, study_.posted());
  }
  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& /*run*/,
                      const SendToSimulation& /*send*/) override {
    return store(curves_, study_.newest());
  }
  void report(HostEvents& events) override {
    if (store(reported_, curves_) && curves_ && !curves_->folder.empty()) report_read(*curves_, events);
    const auto newest = saver_.newest();
    if (!store(saved_, newest) || !newest) return;
    const bool is_good = newest->problem.empty();
    events.emplace_back(
        HostMessage{is_good ? Severity::note : Severity::error, is_good ? newest->text : newest->problem});
  }
  void fill(ui::App& app) const override {
    app.get<ui::StudyState>().shown = {curves_, study_.busy(), study_.fraction()};
    app.get<ui::StudyState>().saving = {saver_.busy(), saver_.fraction()};
  }
  [[nodiscard]] bool busy() const override { return study_.busy() || saver_.busy(); }

 private:
  static void report_read(const StudyCurves& curves, HostEvents& events) {
    if (curves.problem.empty()) {
      events.emplace_back(StudyRead{curves.folder});
    } else {
      events.emplace_back(HostMessage{Severity::error, curves.problem});
    }
  }

  StudyJob study_;
  StudySaver saver_;
  StudyJob::ResultPtr curves_, reported_;
  StudySaver::ResultPtr saved_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_study_job(JobExecutor& executor) {
  return std::make_unique<StudyOfFeature>(executor);
}

}  // namespace taxel::studio
