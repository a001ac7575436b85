#include "app/studio/nouns/study/study_job.h"

#include <algorithm>
#include <utility>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/base/text/shown_message.h"
#include "core/run/data_set/study_of_data_set.h"
#include "core/sim/study/run_study.h"

namespace taxel::studio {

namespace {

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
    curves = read_study_of_data_set(input.request.folder, progress);
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
  if (model) post(StudyInput{*request, model}, Superseded::cancel);
}

}  // namespace taxel::studio
