#include "app/studio/features/explain/explain_worker.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/sensor/explain/reading_floor.h"

namespace taxel::studio {
namespace {

/// Returns the sensor at the previous step, or null if another model read it.
const SensorStep* sensor_before(const SimFrame& frame, int sensor) {
  const Step* before = frame.before.get();
  if (before == nullptr || at(sensor) >= before->sensors.size() ||
      before->scene->sensors[at(sensor)] != frame.scene->sensors[at(sensor)])
    return nullptr;
  return &before->sensors[at(sensor)];
}

/// The largest reading of the taxel in the run as far as it is recorded, or of the sensor.
double largest_known(const SimFrame& frame, int sensor, int taxel, const SensorModel& model) {
  double largest = reading_floor(model);
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return largest;
  std::size_t first = 0;
  for (int s = 0; s < sensor; ++s) first += frame.sensors[at(s)].readings.size();
  const std::size_t count = frame.sensors[at(sensor)].readings.size();
  for (std::size_t k = 0; k < count && first + k < lanes->reading_count; ++k)
    if (frame.breakpoints.of_sensor || static_cast<int>(k) == taxel)
      largest = std::max(largest, largest_reading(*lanes, first + k));
  return largest;
}

}  // namespace

bool ExplainWorker::Job::operator==(const Job& other) const {
  const SimFrame &a = *frame, &b = *other.frame;
  return request == other.request && a.step == b.step && a.runs == b.runs && a.scene == b.scene &&
         (a.before == nullptr) == (b.before == nullptr) && a.breakpoints == b.breakpoints;
}

ExplainWorker::ExplainWorker(std::function<void()> wake)
    : worker_([this](const Job& job, Progress& progress) { return attempt(job, progress); }, std::move(wake),
              Overtaken::cancel) {}

void ExplainWorker::explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request) {
  const bool there = frame && request && at(request->sensor) < frame->sensors.size();
  worker_.ask(there ? std::optional(Job{frame, *request}) : std::nullopt);
}

ui::ExplainedPtr ExplainWorker::attempt(const Job& job, Progress& progress) {
  auto out = std::make_shared<ui::ExplainedStep>();
  out->request = job.request;
  out->step = job.frame->step;
  try {
    const SimFrame& frame = *job.frame;
    const SensorModelPtr& model = frame.scene->sensors[at(job.request.sensor)];
    const std::vector<Taxel>& taxels = model->layout.taxels;
    const auto taxel =
        std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == job.request.taxel; });
    const SensorStep& now = frame.sensors[at(job.request.sensor)];
    const int number = taxel != taxels.end() ? static_cast<int>(taxel - taxels.begin()) : -1;
    const ExplainLimits limits{frame.breakpoints.jump, frame.breakpoints.equal_force,
                               largest_known(frame, job.request.sensor, number, *model), frame.breakpoints.of_sensor};
    out->explanation = explainer_.explain(number, now, sensor_before(frame, job.request.sensor), limits, &progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    out->problem = error.what();
  }
  return out;
}

}  // namespace taxel::studio
