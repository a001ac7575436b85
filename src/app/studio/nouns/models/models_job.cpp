// Reads the recorded steps with other sensor models on a worker, a few steps at a time.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/models/models_state.h"
#include "core/base/math.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/sim/compare/model_comparison.h"

namespace taxel::studio {
namespace {

/// RecallCommand::asker of this job.
constexpr int kModelsAsks = 0;

class ModelsJob {
 public:
  explicit ModelsJob(JobExecutor& executor);

  /// Sets the request. Without a request, nothing is compared any more.
  void compare(std::optional<ui::ModelsRequest> request) { request_ = request; }
  /// Reads the displayed step and the recalled steps. While the simulation runs (`runs`), the present result stays.
  /// Returns the command that recalls the next steps.
  std::optional<RecallCommand> follow(const SimFramePtr& frame, bool runs);
  /// Accepts the reply to the command that follow() returned last.
  void accept(StepsRecalled recalled);
  [[nodiscard]] ui::ComparedPtr newest() const { return slot_.newest(); }
  void wait() const { slot_.wait(); }
  /// Returns whether more steps will be read without a new request.
  [[nodiscard]] bool busy() const { return slot_.busy() || (request_ && !complete_); }

  struct Input {
    SimFramePtr frame;
    int sensor = 0;
    std::uint64_t generation = 0;
    std::shared_ptr<const StepsRecalled> recalled;  ///< steps to read besides the displayed one, or null
    std::size_t due = 0;
    /// Compares the step: frames are created again whenever anything changes.
    bool operator==(const Input& other) const;
  };
  struct Result : ui::ComparedSteps {
    std::uint64_t generation = 0;
    std::shared_ptr<const StepsRecalled> recalled;  ///< recalled steps of the input
  };

 private:
  void forget_what_changed(const SimFrame& frame, int sensor);

  std::optional<ui::ModelsRequest> request_;
  StepId read_;  ///< run and models of this generation; its step is 0
  int sensor_ = -1;
  std::uint64_t generation_ = 0;
  std::shared_ptr<const StepsRecalled> recalled_;  ///< newest reply, or null
  bool awaits_reply_ = false;                      ///< whether the newest command has no reply yet
  std::set<std::uint64_t> recalled_steps_;         ///< recalled or displayed steps of this generation
  bool complete_ = true;

  NewestWins<Input, Result> slot_;
};

constexpr std::size_t kMaxSteps = 120;  // most steps to compare, because a plot cannot show more
constexpr std::size_t kBatch = 6;       // steps copied at a time, and read before more are recalled

/// Returns steps spread evenly over the recorded steps, including the newest step.
std::vector<std::uint64_t> wanted_steps(const SimFrame& frame) {
  std::vector<std::uint64_t> wanted;
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return wanted;
  const std::size_t stride = (lanes->rows() + kMaxSteps - 1) / kMaxSteps;
  for (std::size_t row = (lanes->rows() - 1) % stride; row < lanes->rows(); row += stride)
    wanted.push_back(lanes->steps[row].step);
  return wanted;
}

/// Returns whether the recorded step is still the step that was read.
bool is_recorded(const HistoryLanes& lanes, const SimFrame& frame, int sensor, const ComparedStep& step) {
  if (lanes.rows() == 0 || step.step < lanes.steps.front().step || step.step > lanes.steps.back().step) return true;
  std::size_t first = 0;
  for (std::size_t s = 0; s < at(sensor); ++s) first += frame.sensors[s].readings.size();
  const std::span<const double> all = lanes.readings_of(lanes.row_of(step.step));
  const std::vector<double>& values = step.readings[ReadingModel::reading].values;
  return first + values.size() > all.size() ||
         std::equal(values.begin(), values.end(), all.begin() + std::ptrdiff_t(first));
}

/// Reads steps and retains the steps of one generation.
class StepComparer {
 public:
  void operator()(const ModelsJob::Input& input, ModelsJob::Result& out, Progress& progress) {
    const SimFrame& frame = *input.frame;
    out.generation = input.generation;
    out.recalled = input.recalled;
    out.sensor = input.sensor;
    out.model = frame.scene->sensors[at(input.sensor)];
    out.due = input.due;
    if (generation_ != input.generation) steps_.clear();
    generation_ = input.generation;
    if (!comparison_ || comparison_->scene() != frame.scene || comparison_->sensor() != at(input.sensor))
      comparison_ = std::make_unique<ModelComparison>(frame.scene, at(input.sensor), &progress);
    std::erase_if(
        steps_, [&](const auto& step) { return step.first < frame.history.first || step.first > frame.history.last; });
    add(frame);
    for (const StepPtr& step : input.recalled ? input.recalled->steps : std::vector<StepPtr>{}) {
      progress.stop_if_cancelled();
      if (step->scene == frame.scene) add(*step);
    }
    for (const auto& [number, step] : steps_) out.steps.push_back(step);
  }

 private:
  void add(const Step& step) {
    if (steps_.contains(step.step)) return;
    steps_[step.step] = std::make_shared<const ComparedStep>(
        ComparedStep{step.step, step.time, step.travel, comparison_->read(view_of(step)), false});
  }

  std::unique_ptr<ModelComparison> comparison_;
  std::uint64_t generation_ = 0;
  std::map<std::uint64_t, ComparedStepPtr> steps_;  ///< read steps by step number
};

}  // namespace

bool ModelsJob::Input::operator==(const Input& other) const {
  return frame->id() == other.frame->id() && frame->history.first == other.frame->history.first &&
         sensor == other.sensor && generation == other.generation && recalled == other.recalled && due == other.due;
}

ModelsJob::ModelsJob(JobExecutor& executor)
    : slot_(executor, Priority::background,
            [comparer = std::make_shared<StepComparer>()](const Input& input, Result& out, Progress& progress) {
              (*comparer)(input, out, progress);
            }) {}

/// Begins a new generation, in which all steps are read again, if the scene, the sensor or recorded steps changed.
void ModelsJob::forget_what_changed(const SimFrame& frame, int sensor) {
  const StepId id{frame.runs, 0, frame.id().model_edition};
  bool changed = id != read_ || sensor != sensor_;
  if (const auto result = slot_.newest(); result && result->generation == generation_ && frame.history.lanes)
    for (const ComparedStepPtr& step : result->steps)
      changed = changed || !is_recorded(*frame.history.lanes, frame, sensor, *step);
  std::erase_if(recalled_steps_,
                [&](std::uint64_t step) { return step < frame.history.first || step > frame.history.last; });
  if (!changed) return;
  read_ = id;
  sensor_ = sensor;
  ++generation_;
  recalled_steps_.clear();
}

std::optional<RecallCommand> ModelsJob::follow(const SimFramePtr& frame, bool runs) {
  const bool has_sensor = request_ && frame && frame->scene && at(request_->sensor) < frame->sensors.size() &&
                          frame->scene->sensors[at(request_->sensor)] &&
                          frame->scene->sensors[at(request_->sensor)]->taxel_count() > 0;
  if (!has_sensor) {
    slot_.post(std::nullopt);
    complete_ = true;
    return std::nullopt;
  }
  complete_ = complete_ || runs;
  if (runs) return std::nullopt;
  forget_what_changed(*frame, request_->sensor);
  const std::vector<std::uint64_t> wanted = wanted_steps(*frame);
  slot_.post(Input{frame, request_->sensor, generation_, awaits_reply_ ? nullptr : recalled_, wanted.size()});
  const auto result = slot_.newest();
  const bool is_read = result && result->generation == generation_ && result->recalled == recalled_;
  complete_ = false;
  if (awaits_reply_ || !is_read) return std::nullopt;
  for (const ComparedStepPtr& step : result->steps) recalled_steps_.insert(step->step);  // steps that were displayed
  RecallCommand next;
  for (const std::uint64_t step : wanted) {
    if (next.steps.size() == kBatch) break;
    if (recalled_steps_.insert(step).second) next.steps.push_back(step);
  }
  complete_ = next.steps.empty();
  if (complete_) return std::nullopt;
  awaits_reply_ = true;
  return next;
}

void ModelsJob::accept(StepsRecalled recalled) {
  recalled_ = std::make_shared<const StepsRecalled>(std::move(recalled));
  awaits_reply_ = false;
}

namespace {

class ModelsOfFeature final : public RecallingJob<ModelsJob, ui::ComparedPtr> {
 public:
  explicit ModelsOfFeature(JobExecutor& executor) : RecallingJob(executor, kModelsAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    job().compare(ui::models_request(*app.viewer, *app.shown, app.get<ui::PanelsShown>()[ui::kModels]));
  }
  void fill(ui::App& app) const override { app.get<ui::ModelsState>().compared = result(); }

 private:
  std::optional<RecallCommand> follow(ModelsJob& job, const FollowedRun& run) override {
    return job.follow(run.frame, run.runs);
  }
};

}  // namespace

std::unique_ptr<FeatureJob> make_models_job(JobExecutor& executor) {
  return std::make_unique<ModelsOfFeature>(executor);
}

}  // namespace taxel::studio
