#include "app/studio/features/study/study_job.h"

#include <algorithm>
#include <utility>

#include "core/sim/study/side_by_side.h"

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

void record_run(Simulator& simulator, StudyCurve& curve, const Progress& progress) {
  try {
    while (!simulator.finished()) {
      progress.stop_if_cancelled();
      simulator.step();
      if (!simulator.row_due()) continue;
      const StepView step = simulator.view();
      const std::span<const double> readings = step.sensors.front().readings;
      curve.time.push_back(step.time);
      curve.readings.resize(readings.size());
      for (std::size_t k = 0; k < readings.size(); ++k) curve.readings[k].push_back(readings[k]);
    }
  } catch (const Error& e) {
    curve.error = e.what();
  }
}

void run_study(const StudyInput& input, StudyCurves& curves, Progress& progress) {
  curves.study = input.request.study;
  for (const Taxel& taxel : input.model->layout.taxels) curves.taxel_ids.push_back(taxel.id);
  for (const StudyRun& run : runs_of(curves.study)) curves.runs.push_back({run, {}, {}, {}});
  SensorCache cache;
  try {
    run_side_by_side(
        static_cast<int>(curves.runs.size()),
        [&](int i) {
          const StudyRun& run = curves.runs[static_cast<std::size_t>(i)].run;
          return Simulator::make_scenario(model_of(run, input.model, cache, progress), run.scenario);
        },
        [&](int i, Simulator& simulator) { record_run(simulator, curves.runs[static_cast<std::size_t>(i)], progress); },
        progress);
  } catch (const Error& e) {
    curves.problem = e.what();
  }
  for (const StudyCurve& curve : curves.runs) {
    if (!curve.time.empty()) curves.longest = std::max(curves.longest, curve.time.back());
    for (const std::vector<double>& readings : curve.readings)
      for (const double reading : readings) curves.largest_reading = std::max(curves.largest_reading, reading);
  }
}

}  // namespace

StudyJob::StudyJob(JobPool& pool, std::function<void()> wake)
    : NewestWins(pool, Priority::background, run_study, std::move(wake)) {}

}  // namespace taxel::studio
