#include "app/studio/nouns/compare/compare_job.h"

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/compare/compare.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/compare/compare_tool.h"
#include "core/base/index.h"

namespace taxel::studio {
namespace {

constexpr std::size_t kComparedBatch = 32;  // steps copied at a time, and read before more are recalled

/// Returns the sensor's model of a frame, or null if the frame has no such sensor with taxels.
const SensorModel* compared_model(const SimFramePtr& frame, int sensor) {
  if (!frame || !frame->scene || at(sensor) >= frame->sensors.size() || at(sensor) >= frame->scene->sensors.size())
    return nullptr;
  const SensorModel* model = frame->scene->sensors[at(sensor)].get();
  return model != nullptr && model->taxel_count() > 0 ? model : nullptr;
}

}  // namespace

bool CompareInput::operator==(const CompareInput& other) const {
  return frame->id() == other.frame->id() && request == other.request && generation == other.generation &&
         recalled == other.recalled;
}

CompareJob::CompareJob(JobExecutor& executor)
    : slot_(executor, Priority::background,
            [reader = std::make_shared<LayoutReader>()](const CompareInput& input, CompareResult& out,
                                                        Progress& progress) {
              out.generation = input.generation;
              out.recalled = input.recalled;
              reader->read(input, out, progress);
            }) {}

ui::CompareProgress CompareJob::progress() const {
  return {slot_.busy() || !complete_, slot_.fraction(), read_, due_};
}

/// Begins a new generation, in which the steps are checked and read again, if the models, the run or recorded steps
/// have changed. Returns whether the request has changed.
bool CompareJob::begin_generation(const SimFrame& frame) {
  const HistoryLanes* lanes = frame.history.lanes.get();
  const CompareSubject subject{*request_, frame.runs, frame.id().model_edition, lanes != nullptr ? lanes->edition : 0};
  if (subject == subject_) return false;
  const bool is_other = !(subject.request == subject_.request);
  subject_ = subject;
  ++generation_;
  recalled_.reset();
  requested_until_ = -std::numeric_limits<double>::infinity();
  read_ = 0;
  return is_other;
}

/// Returns the command for the rows of the run after the rows that were read, as far as the history has them.
std::optional<RecallCommand> CompareJob::next_steps(const SimFrame& frame, const CompareResult& result) {
  const std::vector<TraceRow>& trace = frame.trace->rows;
  const HistoryLanes& lanes = *frame.history.lanes;
  if (!result.rows.empty()) requested_until_ = std::max(requested_until_, result.rows.back()->time);
  auto row = std::upper_bound(trace.begin(), trace.end(), requested_until_,
                              [](double time, const TraceRow& r) { return time < r.time; });
  RecallCommand next{{}, kCompareAsks};
  for (; row != trace.end() && next.steps.size() < kComparedBatch; ++row) {
    const StepMark* const mark = std::lower_bound(lanes.steps.begin(), lanes.steps.end(), row->time,
                                                  [](const StepMark& m, double time) { return m.time < time; });
    if (mark == lanes.steps.end()) break;  // the newest rows of the lanes may be missing
    if (mark->time == row->time) next.steps.push_back(mark->step);
    requested_until_ = row->time;
  }
  read_ = static_cast<std::size_t>(row - trace.begin());
  return next.steps.empty() ? std::nullopt : std::optional(std::move(next));
}

std::optional<RecallCommand> CompareJob::follow(const SimFramePtr& frame, bool runs) {
  if (!request_ || compared_model(frame, request_->sensor) == nullptr) {
    slot_.post(std::nullopt, Superseded::cancel);
    complete_ = true;
    read_ = due_ = 0;
    return std::nullopt;
  }
  const bool is_other = begin_generation(*frame);
  slot_.post(CompareInput{frame, *request_, generation_, awaits_reply_ ? nullptr : recalled_},
             is_other ? Superseded::cancel : Superseded::finish);
  due_ = frame->trace ? frame->trace->rows.size() : 0;
  const auto result = slot_.newest();
  const bool is_read = result && result->generation == generation_ && result->recalled == recalled_;
  const bool reads_more = frame->trace && frame->history.lanes && !request_->stopped;
  complete_ = runs || !reads_more || (is_read && !result->problem.empty());
  if (awaits_reply_ || !is_read || !reads_more || !result->problem.empty()) return std::nullopt;
  std::optional<RecallCommand> next = next_steps(*frame, *result);
  complete_ = complete_ || !next;
  awaits_reply_ = next.has_value();
  recall_generation_ = generation_;
  return next;
}

void CompareJob::accept(StepsRecalled recalled) {
  awaits_reply_ = false;
  if (recall_generation_ != generation_) return;  // the steps may be those of an earlier run
  recalled_ = std::make_shared<const StepsRecalled>(std::move(recalled));
}

namespace {

class CompareOfFeature final : public RecallingJob<CompareJob, ui::ComparedLayoutsPtr> {
 public:
  explicit CompareOfFeature(JobExecutor& executor) : RecallingJob(executor, kCompareAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    const auto& state = app.get<ui::CompareState>();
    auto second = ui::compare_request(*app.viewer, *app.shown, state, app.get<ui::PanelsShown>()[ui::kCompare]);
    job().compare(
        second ? std::optional(CompareJob::Request{std::move(*second), app.viewer->selection.sensor, state.stopped})
               : std::nullopt);
  }
  void fill(ui::App& app) const override {
    app.get<ui::CompareState>().compared = result();
    app.get<ui::CompareState>().progress = job().progress();
  }

 private:
  std::optional<RecallCommand> follow(CompareJob& job, const FollowedRun& run) override {
    return job.follow(run.frame, run.runs);
  }
};

}  // namespace

std::unique_ptr<FeatureJob> make_compare_job(JobExecutor& executor) {
  return std::make_unique<CompareOfFeature>(executor);
}

}  // namespace taxel::studio
