// Reads the recorded steps with a second layout on a worker, a few steps at a time, also while the simulation runs.
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sim/compare/second_sensor.h"

namespace taxel::studio {
namespace {

/// A second layout for one sensor of the simulation.
struct CompareJobRequest {
  ui::CompareRequest second;
  int sensor = 0;
  bool stopped = false;  ///< only the displayed step is read
  bool operator==(const CompareJobRequest&) const = default;
};

struct CompareInput {
  SimFramePtr frame;
  CompareJobRequest request;
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< steps to read besides the displayed one, or null
  /// Compares the step: frames are created again whenever anything changes.
  bool operator==(const CompareInput& other) const;
};
struct CompareResult : ui::ComparedLayouts {
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< recalled steps of the input
};

/// Reads steps with two layouts, and retains the readings. Used by one worker at a time.
class LayoutReader {
 public:
  /// Reads the displayed and the recalled steps of the input that were not read yet. Sets `out.problem` if the second
  /// layout cannot be read. Throws Cancelled.
  void read(const CompareInput& input, CompareResult& out, Progress& progress);

 private:
  void build(const CompareInput& input, const SensorModelPtr& first, Progress& progress);
  void drop_changed_rows(const SimFrame& frame, std::size_t sensor);
  void add_row(const Step& step, std::size_t sensor, const Trace* trace);
  [[nodiscard]] ComparedStepPtr displayed_row(const SimFrame& frame, std::size_t sensor) const;

  SensorCache cache_;
  ui::CompareRequest request_;  ///< request of `second_` or `problem_`
  SensorModelPtr first_;
  std::unique_ptr<const SecondSensor> second_;
  std::shared_ptr<const std::vector<Taxel>> taxels_;  ///< see ComparedLayouts::taxels_of_b
  bool equal_contact_ = true;
  std::string problem_;  ///< why there is no `second_`, or empty

  int sensor_ = -1;
  std::uint64_t runs_ = 0, generation_ = 0;  ///< run and generation that `rows_` belong to
  std::vector<ComparedStepPtr> rows_;        ///< rows of the run, ascending
};

/// RecallCommand::asker of this job.
constexpr int kCompareAsks = 1;

/// The steps that were read by the same models of the same run.
struct CompareSubject {
  CompareJobRequest request;
  std::uint64_t runs = 0, model_edition = 0, lanes_edition = 0;
  bool operator==(const CompareSubject&) const = default;
};

class CompareJob {
 public:
  using Request = CompareJobRequest;

  explicit CompareJob(JobExecutor& executor);

  /// Sets the request. Without a request, nothing is compared any more.
  void compare(std::optional<Request> request) { request_ = std::move(request); }
  /// Reads the displayed step and the recalled steps. Returns the command that recalls the next steps.
  std::optional<RecallCommand> follow(const SimFramePtr& frame, bool runs);
  /// Accepts the reply to the command that follow() returned last.
  void accept(StepsRecalled recalled);
  [[nodiscard]] ui::ComparedLayoutsPtr newest() const { return slot_.newest(); }
  [[nodiscard]] ui::CompareProgress progress() const;
  /// Returns whether more steps will be read without a new request, although the simulation does not run.
  [[nodiscard]] bool busy() const { return slot_.busy() || (request_ && !complete_); }

 private:
  bool begin_generation(const SimFrame& frame);
  std::optional<RecallCommand> next_steps(const SimFrame& frame, const CompareResult& result);

  std::optional<Request> request_;
  CompareSubject subject_;
  std::uint64_t generation_ = 0, recall_generation_ = 0;               ///< present one, and that of the newest command
  std::shared_ptr<const StepsRecalled> recalled_;                      ///< newest reply, or null
  bool awaits_reply_ = false;                                          ///< whether the newest command has no reply yet
  double requested_until_ = -std::numeric_limits<double>::infinity();  ///< time of the newest requested row [s]
  std::size_t read_ = 0, due_ = 0;                                     ///< see CompareProgress
  bool complete_ = true;

  NewestWins<CompareInput, CompareResult> slot_;
};

/// Returns whether a row of the run was skipped between two rows of the comparison.
bool skips_row(const Trace& trace, double before, double time) {
  const std::vector<TraceRow>& rows = trace.rows;
  const auto next =
      std::upper_bound(rows.begin(), rows.end(), before, [](double t, const TraceRow& row) { return t < row.time; });
  return next != rows.end() && next->time < time;
}

}  // namespace

/// Compiles the second layout, unless the request and the first layout are those of the last call.
void LayoutReader::build(const CompareInput& input, const SensorModelPtr& first, Progress& progress) {
  const ui::CompareRequest& request = input.request.second;
  if (request_ == request && first_ == first && (second_ || !problem_.empty())) return;
  request_ = request;
  first_ = first;
  second_.reset();
  taxels_.reset();
  rows_.clear();
  problem_.clear();
  try {
    const Layout layout =
        request.is_paper() ? released_model_of(first->layout) : read_second_layout(request.file, *first);
    if (layout.taxels != first->layout.taxels) taxels_ = std::make_shared<const std::vector<Taxel>>(layout.taxels);
    equal_contact_ = has_equal_contact(first->layout, layout);
    const std::string& name = request.is_paper() ? layout.name : request.file;
    second_ = std::make_unique<const SecondSensor>(first, layout, request.contact, name, &cache_, &progress);
  } catch (const Error& error) {
    problem_ = shown_message(error);
  }
}

/// Drops the rows of another run, and the rows from the first one on that the run has replaced.
void LayoutReader::drop_changed_rows(const SimFrame& frame, std::size_t sensor) {
  if (runs_ != frame.runs || at(sensor_) != sensor) rows_.clear();
  runs_ = frame.runs;
  sensor_ = static_cast<int>(sensor);
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return rows_.clear();
  std::size_t first = 0;
  for (std::size_t s = 0; s < sensor; ++s) first += frame.sensors[s].readings.size();
  const auto is_replaced = [&](const ComparedStepPtr& row) {
    if (row->step < lanes->steps.front().step) return false;  // the run continues after this step
    if (row->step > lanes->steps.back().step) return true;
    const std::span<const double> all = lanes->readings_of(lanes->row_of(row->step));
    const std::vector<double>& ours = row->readings[ReadingModel::reading].values;
    return first + ours.size() > all.size() ||
           !std::equal(ours.begin(), ours.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
  };
  rows_.erase(std::find_if(rows_.begin(), rows_.end(), is_replaced), rows_.end());
}

void LayoutReader::add_row(const Step& step, std::size_t sensor, const Trace* trace) {
  if (!rows_.empty() && step.step <= rows_.back()->step) return;
  ComparedStep row{step.step, step.time, step.travel, second_->read(view_of(step), sensor)};
  row.after_gap = !rows_.empty() && trace != nullptr && skips_row(*trace, rows_.back()->time, step.time);
  rows_.push_back(std::make_shared<const ComparedStep>(std::move(row)));
}

ComparedStepPtr LayoutReader::displayed_row(const SimFrame& frame, std::size_t sensor) const {
  const auto found = std::lower_bound(rows_.begin(), rows_.end(), frame.step,
                                      [](const ComparedStepPtr& row, std::uint64_t step) { return row->step < step; });
  if (found != rows_.end() && (*found)->step == frame.step) return *found;
  return std::make_shared<const ComparedStep>(
      ComparedStep{frame.step, frame.time, frame.travel, second_->read(view_of(frame), sensor)});
}

void LayoutReader::read(const CompareInput& input, CompareResult& out, Progress& progress) {
  const SimFrame& frame = *input.frame;
  const std::size_t sensor = at(input.request.sensor);
  out.request = input.request.second;
  out.sensor = input.request.sensor;
  out.model = frame.scene->sensors[sensor];
  build(input, out.model, progress);
  out.equal_contact = equal_contact_;
  out.problem = problem_;
  if (!second_) return;
  out.b = second_->model();
  out.taxels_of_b = taxels_;
  out.reads_recorded = second_->reads_recorded();
  if (generation_ != input.generation) drop_changed_rows(frame, sensor);
  generation_ = input.generation;
  try {
    for (const StepPtr& step : input.recalled ? input.recalled->steps : std::vector<StepPtr>{}) {
      progress.stop_if_cancelled();
      if (step->scene == frame.scene) add_row(*step, sensor, frame.trace.get());
    }
    out.displayed = displayed_row(frame, sensor);
  } catch (const Error& error) {
    out.problem = shown_message(error);
  }
  out.steps = rows_;
}

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
  if (!result.steps.empty()) requested_until_ = std::max(requested_until_, result.steps.back()->time);
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
