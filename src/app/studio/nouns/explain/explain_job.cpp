// Explains a reading on a worker.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "core/base/math.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sensor/explain/explainer.h"
#include "core/sensor/explain/explanation.h"

namespace taxel::studio {
namespace {

/// RecallCommand::asker of this job.
constexpr int kExplainAsks = 2;

struct ExplainInput {
  SimFramePtr frame;
  ui::ExplainRequest request;
  /// The steps between which the reading of the taxel changes most in the run, in order; fewer than two if unknown.
  std::vector<StepPtr> worst;
  /// Compares the explained step: frames are created again whenever anything changes.
  bool operator==(const ExplainInput& other) const;
};

class ExplainJob : public NewestWins<ExplainInput, ui::ExplainedStep> {
 public:
  explicit ExplainJob(JobExecutor& executor);

  /// Sets the taxel to explain in every displayed step. Without a request nothing is explained. `send` receives the
  /// command by which the simulation sends the previous step too, or no longer.
  void request(std::optional<ui::ExplainRequest> request, const std::function<void(SimCommand)>& send);
  void forget_request() { request_.reset(); }
  /// Posts the requested taxel in the step of `frame`. While `keeps_result`, the newest result stays. Returns the
  /// command that recalls the steps between which the reading changes most in the run; they are explained too.
  std::optional<RecallCommand> follow(const SimFramePtr& frame, bool keeps_result);
  /// Accepts the reply to the command that follow() returned last.
  void accept(StepsRecalled recalled);
  /// Returns whether an explanation is under way.
  [[nodiscard]] bool busy() const { return NewestWins::busy() || awaits_reply_; }
  /// Posts the taxel in the step of `frame`, which is compared with the previous step that the frame carries. Without a
  /// request or a frame nothing is explained any more.
  void explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request);

 private:
  /// The change that was recalled, and where it was looked for.
  struct Worst {
    std::uint64_t runs = 0, edition = 0;  ///< the run, and the edition of its lanes
    std::vector<std::uint64_t> steps;     ///< the two steps of the change, or none
    ui::ExplainRequest request;
    bool operator==(const Worst&) const = default;
  };

  std::optional<ui::ExplainRequest> request_;
  Worst worst_;
  std::vector<StepPtr> worst_steps_;
  bool awaits_reply_ = false;
};

/// Returns the sensor at the previous step, or null if another model read it.
const SensorStep* sensor_before(const SimFrame& frame, int sensor) {
  const Step* before = frame.before.get();
  if (before == nullptr || at(sensor) >= before->sensors.size() ||
      before->scene->sensors[at(sensor)] != frame.scene->sensors[at(sensor)])
    return nullptr;
  return &before->sensors[at(sensor)];
}

/// Returns the two recorded steps between which the reading of a taxel changes most, or nothing.
std::vector<std::uint64_t> worst_steps(const SimFrame& frame, const ui::ExplainRequest& request) {
  const HistoryLanes* lanes = frame.history.lanes.get();
  const SensorModelPtr& model = frame.scene->sensors[at(request.sensor)];
  const int taxel = model ? ui::index_of(model->layout, request.taxel) : -1;
  if (lanes == nullptr || taxel < 0) return {};
  const std::size_t reading = frame.first_reading(at(request.sensor)) + at(taxel);
  if (reading >= lanes->reading_count) return {};
  std::vector<std::uint64_t> worst;
  double largest = 0;
  for (std::size_t row = 1; row < lanes->rows(); ++row) {
    const double change = std::abs(lanes->readings_of(row)[reading] - lanes->readings_of(row - 1)[reading]);
    if (change > largest) largest = change, worst = {lanes->steps[row - 1].step, lanes->steps[row].step};
  }
  return worst;
}

/// Returns the largest recorded reading of the taxel in the run, or of the sensor.
double largest_known(const SimFrame& frame, int sensor, int taxel, bool of_sensor, const SensorModel& model) {
  double largest = reading_floor(model);
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return largest;
  const std::size_t first = frame.first_reading(at(sensor));
  const std::size_t count = frame.sensors[at(sensor)].readings.size();
  for (std::size_t k = 0; k < count && first + k < lanes->reading_count; ++k)
    if (of_sensor || static_cast<int>(k) == taxel) largest = std::max(largest, largest_reading(*lanes, first + k));
  return largest;
}

void explain_step(Explainer& explainer, const ExplainInput& input, ui::ExplainedStep& out, Progress& progress) {
  const SimFrame& frame = *input.frame;
  const int sensor = input.request.sensor;
  out.request = input.request;
  out.step = frame.step;
  const SensorModelPtr& model = frame.scene->sensors[at(sensor)];
  const int number = ui::index_of(model->layout, input.request.taxel);
  const bool of_sensor = frame.breakpoints.of_sensor;
  const ExplainLimits limits{frame.breakpoints.jump, frame.breakpoints.equal_force,
                             largest_known(frame, sensor, number, of_sensor, *model), of_sensor,
                             largest_known(frame, sensor, number, true, *model)};
  StepPair worst;
  if (input.worst.size() == 2) worst = {&input.worst[0]->sensors[at(sensor)], &input.worst[1]->sensors[at(sensor)]};
  out.explanation =
      explainer.explain(number, frame.sensors[at(sensor)], sensor_before(frame, sensor), limits, &progress, worst);
}

}  // namespace

bool ExplainInput::operator==(const ExplainInput& other) const {
  const SimFrame &a = *frame, &b = *other.frame;
  return request == other.request && a.id() == b.id() && (a.before == nullptr) == (b.before == nullptr) &&
         a.breakpoints == b.breakpoints && worst == other.worst;
}

ExplainJob::ExplainJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal,
                 [explainer = std::make_shared<Explainer>()](const ExplainInput& input, ui::ExplainedStep& out,
                                                             Progress& progress) {
                   explain_step(*explainer, input, out, progress);
                 }) {}

void ExplainJob::request(std::optional<ui::ExplainRequest> request, const std::function<void(SimCommand)>& send) {
  const bool switches = request.has_value() != request_.has_value();
  request_ = request;
  if (switches) send(FollowStepBeforeCommand{request_.has_value()});
}

std::optional<RecallCommand> ExplainJob::follow(const SimFramePtr& frame, bool keeps_result) {
  if (keeps_result && request_) return std::nullopt;
  std::optional<RecallCommand> recall;
  const bool has_rows = request_ && frame && frame->scene && frame->history.lanes &&
                        at(request_->sensor) < frame->sensors.size() && !awaits_reply_;
  if (has_rows) {
    const HistoryLanes& lanes = *frame->history.lanes;
    const Worst worst{frame->runs, lanes.edition, worst_steps(*frame, *request_), *request_};
    if (!(worst == worst_)) {
      worst_ = worst;
      worst_steps_.clear();
      awaits_reply_ = !worst.steps.empty();
      if (awaits_reply_) recall = RecallCommand{worst.steps, kExplainAsks};
    }
  }
  if (!awaits_reply_) explain(frame, request_);
  return recall;
}

/// The steps of another scene are of no use: the models differ.
void ExplainJob::accept(StepsRecalled recalled) {
  awaits_reply_ = false;
  worst_steps_ = std::move(recalled.steps);
  const auto is_other = [&](const StepPtr& step) {
    return at(worst_.request.sensor) >= step->sensors.size() || !step->scene;
  };
  if (std::any_of(worst_steps_.begin(), worst_steps_.end(), is_other)) worst_steps_.clear();
}

void ExplainJob::explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request) {
  const bool has_sensor = frame && request && at(request->sensor) < frame->sensors.size();
  post(has_sensor ? std::optional(ExplainInput{frame, *request, worst_steps_}) : std::nullopt, Superseded::cancel);
}

namespace {

class ExplainOfFeature final : public RecallingJob<ExplainJob, ui::ExplainedPtr> {
 public:
  explicit ExplainOfFeature(JobExecutor& executor) : RecallingJob(executor, kExplainAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/, const SendToSimulation& send) override {
    job().request(ui::explain_request(*app.viewer, *app.shown, ui::is_in_use(ui::kExplain, app)), send);
  }
  void fill(ui::App& app) const override { app.get<ui::ExplainState>().explained = result(); }
  void drop_scene() override { job().forget_request(); }

 private:
  std::optional<RecallCommand> follow(ExplainJob& job, const FollowedRun& run) override {
    return job.follow(run.frame, run.keeps_explanation);
  }
};

}  // namespace

std::unique_ptr<FeatureJob> make_explain_job(JobExecutor& executor) {
  return std::make_unique<ExplainOfFeature>(executor);
}

}  // namespace taxel::studio
