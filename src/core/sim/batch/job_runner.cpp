#include "core/sim/batch/job_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/limits.h"
#include "core/base/parallel.h"
#include "core/base/text/shown_message.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/follow_simulator.h"
#include "core/sim/simulator.h"

namespace taxel {

JobRunner::Model JobRunner::model_of(const Job& job) {
  std::promise<CompiledLayout> promise;
  Model model;
  {
    const std::scoped_lock lock(models_mutex_);
    const auto known = std::ranges::find(models_, job.layout_key, &std::pair<std::string, Model>::first);
    if (known != models_.end()) {
      models_.splice(models_.begin(), models_, known);
      return models_.front().second;
    }
    model = promise.get_future().share();
    models_.emplace_front(job.layout_key, model);
    if (models_.size() > kKeptModels) models_.pop_back();
  }
  try {
    SensorBuild how;
    how.cache = &cache_;
    const SensorSource source = sources_.changed_source(job.layout, job.changes);
    promise.set_value({build_sensor_model(source, how), JobSources::portable_json(source)});
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return model;
}

Recording JobRunner::record(const Job& job, const SensorModelPtr& model, const JobWatch& watch) {
  std::unique_ptr<Simulator> simulator;
  {
    const std::scoped_lock lock(compiler_mutex_);
    simulator = Simulator::make_scenario(model, job.scenario);
  }
  RunRecorder recorder(*simulator->scene());
  StepView view;
  while (!simulator->finished()) {
    if (watch.is_stopped && watch.is_stopped()) throw BatchStopped();
    simulator->step();
    follow_latest_step(*simulator, recorder, view);
    if (recorder.bytes() > kMaxRecordingBytes)
      throw Error(
          fmt::format("the recording takes more than {} GiB of memory: record fewer rows", kMaxRecordingBytes >> 30U));
  }
  return recorder.take();
}

void JobRunner::run_job(const Job& job, const BatchFormat& format, const JobWatch& watch, GroupResult& result) {
  JobOutcome outcome;
  outcome.id = job.id;
  std::optional<Recording> recording;
  Episode episode;
  try {
    if (!job.error.empty()) throw Error(job.error);
    const CompiledLayout layout = model_of(job).get();
    on_this_core([&] { recording = record(job, layout.model, watch); });
    episode = episode_of(*recording, format.poses);
    if (format.fps > 0) episode = resampled(episode, format.fps);
    if (!result.head.sensor) {
      result.head.sensor = sensor_of(*recording);
      result.head.sensor->layout_key = job.layout_key;
      result.head.sensor->layout_json = layout.json;
      result.head.sensor->layout_name = layout.model->layout.name;
    }
  } catch (const Error& e) {
    outcome.error = job.error.empty() ? shown_message(e) : job.error;
  } catch (const std::bad_alloc&) {
    outcome.error = "there is not enough memory";
  }
  if (outcome.error.empty()) {
    if (watch.on_recording) watch.on_recording(job, *recording);
    outcome.rows = episode.rows;
    outcome.summary = episode.summary;
    result.episodes.push_back(std::move(episode));
  }
  if (watch.on_end) watch.on_end(job, outcome.error);
  result.head.outcomes.push_back(std::move(outcome));
}

GroupResult JobRunner::run(const std::string& group, std::span<const Job* const> jobs, const BatchFormat& format,
                           const JobWatch& watch) {
  GroupResult result;
  result.head.group = group;
  for (const Job* job : jobs) run_job(*job, format, watch, result);
  return result;
}

}  // namespace taxel
