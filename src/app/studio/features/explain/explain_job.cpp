#include "app/studio/features/explain/explain_job.h"

#include <algorithm>
#include <memory>
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

/// Returns the largest recorded reading of the taxel in the run, or of the sensor.
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

void explain_step(Explainer& explainer, const ExplainInput& input, ui::ExplainedStep& out, Progress& progress) {
  const SimFrame& frame = *input.frame;
  const int sensor = input.request.sensor;
  out.request = input.request;
  out.step = frame.step;
  const SensorModelPtr& model = frame.scene->sensors[at(sensor)];
  const std::vector<Taxel>& taxels = model->layout.taxels;
  const auto taxel =
      std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == input.request.taxel; });
  const int number = taxel != taxels.end() ? static_cast<int>(taxel - taxels.begin()) : -1;
  const ExplainLimits limits{frame.breakpoints.jump, frame.breakpoints.equal_force,
                             largest_known(frame, sensor, number, *model), frame.breakpoints.of_sensor};
  out.explanation =
      explainer.explain(number, frame.sensors[at(sensor)], sensor_before(frame, sensor), limits, &progress);
}

}  // namespace

bool ExplainInput::operator==(const ExplainInput& other) const {
  const SimFrame &a = *frame, &b = *other.frame;
  return request == other.request && a.id() == b.id() && (a.before == nullptr) == (b.before == nullptr) &&
         a.breakpoints == b.breakpoints;
}

ExplainJob::ExplainJob(JobExecutor& executor, std::function<void()> wake)
    : NewestWins(
          executor, Priority::normal,
          [explainer = std::make_shared<Explainer>()](const ExplainInput& input, ui::ExplainedStep& out,
                                                      Progress& progress) {
            explain_step(*explainer, input, out, progress);
          },
          std::move(wake)) {}

void ExplainJob::request(std::optional<ui::ExplainRequest> request, const std::function<void(SimCommand)>& send) {
  const bool switches = request.has_value() != request_.has_value();
  request_ = request;
  if (switches) send(FollowStepBeforeCommand{request_.has_value()});
}

void ExplainJob::explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request) {
  const bool has_sensor = frame && request && at(request->sensor) < frame->sensors.size();
  post(has_sensor ? std::optional(ExplainInput{frame, *request}) : std::nullopt, Superseded::cancel);
}

}  // namespace taxel::studio
