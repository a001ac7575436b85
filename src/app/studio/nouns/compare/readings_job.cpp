// Reads the displayed step and recorded steps of a run by several models on a worker, a few steps at a time. The panel
// "Models" reads steps that are spread over the history while the simulation is paused. The panel "Compare" reads each
// row of the run by a second layout, also while the simulation runs.
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
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
#include "app/studio/nouns/models/models_state.h"
#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sim/compare/model_comparison.h"
#include "core/sim/compare/second_sensor.h"

namespace taxel::studio {
namespace {

// RecallCommand::asker of the two jobs.
constexpr int kModelsAsks = 0, kCompareAsks = 1;

/// A sensor of the simulation, and the models that read its steps.
struct ReadingsRequest {
  int sensor = 0;
  std::optional<ui::CompareRequest> second;  ///< second layout, or empty for all of kReadingModels
  bool stopped = false;                      ///< only the displayed step is read
  bool operator==(const ReadingsRequest&) const = default;
};

struct ReadingsInput {
  SimFramePtr frame;
  ReadingsRequest request;
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< steps to read besides the displayed one, or null
  std::size_t due = 0;                            ///< see ComparedSteps
  /// Compares the step: frames are created again whenever anything changes.
  bool operator==(const ReadingsInput& other) const;
};
struct ReadingsResult : ui::ComparedLayouts {
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< recalled steps of the input
};

/// Reads steps by several models, and retains the readings. Used by one worker at a time.
class StepReader {
 public:
  /// Reads the displayed and the recalled steps of the input that were not read yet. Sets `out.problem` if they cannot
  /// be read. Throws Cancelled.
  void read(const ReadingsInput& input, ReadingsResult& out, Progress& progress);

 private:
  /// The models that were built last.
  struct Built {
    std::optional<ui::CompareRequest> second;
    SensorModelPtr first;
    // Null and -1 for a second layout, which depends on `first` alone.
    std::shared_ptr<const SimScene> scene;
    int sensor = -1;
    bool operator==(const Built&) const = default;
  };
  using Rows = ComparedStepList;

  void build(const ReadingsInput& input, Progress& progress);
  void build_second(const ui::CompareRequest& request, const SensorModelPtr& first, Progress& progress);
  void drop_changed_rows(const SimFrame& frame, std::size_t sensor);
  [[nodiscard]] Rows::iterator row_from(std::uint64_t step);
  [[nodiscard]] ComparedStepPtr read_step(const Step& step, std::size_t sensor);
  void add_row(const Step& step, std::size_t sensor, const Trace* trace);

  SensorCache cache_;
  Built built_;
  std::function<ModelReadings(const StepView&, std::size_t sensor)> models_;  ///< not set until they are built
  std::string problem_;                                                       ///< why there are no `models_`, or empty
  std::shared_ptr<const SecondSensor> second_;                                ///< second layout, or null
  std::shared_ptr<const std::vector<Taxel>> taxels_;                          ///< see ComparedLayouts::taxels_of_b
  bool equal_contact_ = true;

  int sensor_ = -1;
  std::uint64_t runs_ = 0, generation_ = 0;  ///< run and generation that `rows_` belong to
  Rows rows_;                                ///< read steps of the run, ascending
};

/// The steps that were read by the same models of the same run.
struct ReadingsSubject {
  ReadingsRequest request;
  std::shared_ptr<const SimScene> scene;
  std::uint64_t runs = 0, lanes_edition = 0;
  bool operator==(const ReadingsSubject&) const = default;
};

class ReadingsJob {
 public:
  explicit ReadingsJob(JobExecutor& executor);

  void request(ReadingsRequest request) { request_.emplace(std::move(request)); }
  /// Reads nothing any more until the next request.
  void end_request() { request_.reset(); }
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
  std::vector<std::uint64_t> next_spread(const std::vector<std::uint64_t>& spread, const ReadingsResult& result);
  std::vector<std::uint64_t> next_rows(const SimFrame& frame, const ReadingsResult& result);

  std::optional<ReadingsRequest> request_;
  ReadingsSubject subject_;
  std::uint64_t generation_ = 0, recall_generation_ = 0;  ///< present one, and that of the newest command
  std::shared_ptr<const StepsRecalled> recalled_;         ///< newest reply, or null
  bool awaits_reply_ = false;                             ///< whether the newest command has no reply yet
  std::set<std::uint64_t> recalled_steps_;                ///< recalled or displayed steps, see next_spread()
  double requested_until_ = -std::numeric_limits<double>::infinity();  ///< time of the newest requested row [s]
  std::size_t read_ = 0, due_ = 0;                                     ///< see CompareProgress
  bool complete_ = true;

  NewestWins<ReadingsInput, ReadingsResult> slot_;
};

/// Returns whether a row of the run was skipped between two rows of the comparison.
bool skips_row(const Trace& trace, double before, double time) {
  const std::vector<TraceRow>& rows = trace.rows;
  const auto next =
      std::upper_bound(rows.begin(), rows.end(), before, [](double t, const TraceRow& row) { return t < row.time; });
  return next != rows.end() && next->time < time;
}

}  // namespace

/// Builds the models, unless those of the last call read the same.
void StepReader::build(const ReadingsInput& input, Progress& progress) {
  const std::shared_ptr<const SimScene>& scene = input.frame->scene;
  const std::size_t sensor = at(input.request.sensor);
  const std::optional<ui::CompareRequest>& second = input.request.second;
  Built wanted{second, scene->sensors[sensor], nullptr, -1};
  if (!second) wanted.scene = scene, wanted.sensor = input.request.sensor;
  if (built_ == wanted && (models_ || !problem_.empty())) return;
  built_ = std::move(wanted);
  models_ = nullptr;
  second_.reset();
  taxels_.reset();
  rows_.clear();
  problem_.clear();
  try {
    if (second) return build_second(*second, built_.first, progress);
    const auto comparison = std::make_shared<ModelComparison>(scene, sensor, &progress);
    models_ = [comparison](const StepView& step, std::size_t /*sensor*/) { return comparison->read(step); };
  } catch (const Error& error) {
    problem_ = shown_message(error);
  }
}

void StepReader::build_second(const ui::CompareRequest& request, const SensorModelPtr& first, Progress& progress) {
  const Layout layout =
      request.is_paper() ? released_model_of(first->layout) : read_second_layout(request.file, *first);
  if (layout.taxels != first->layout.taxels) taxels_ = std::make_shared<const std::vector<Taxel>>(layout.taxels);
  equal_contact_ = has_equal_contact(first->layout, layout);
  const std::string& name = request.is_paper() ? layout.name : request.file;
  second_ = std::make_shared<const SecondSensor>(first, layout, request.contact, name, &cache_, &progress);
  models_ = [second = second_](const StepView& step, std::size_t sensor) { return second->read(step, sensor); };
}

/// Drops the rows of another run, and the rows from the first one on that the run has replaced.
void StepReader::drop_changed_rows(const SimFrame& frame, std::size_t sensor) {
  if (runs_ != frame.runs || at(sensor_) != sensor) rows_.clear();
  runs_ = frame.runs;
  sensor_ = static_cast<int>(sensor);
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return rows_.clear();
  const std::size_t first = frame.first_reading(sensor);
  const auto is_replaced = [&](const ComparedStepPtr& row) {
    if (row->step < lanes->steps.front().step) return false;  // the run continues after this step
    if (row->step > lanes->steps.back().step) return true;
    const std::size_t place = lanes->row_of(row->step);
    const StepMark& mark = lanes->steps[place];
    if (mark.time != row->time || mark.travel != row->travel) return true;  // equal readings, but of another branch
    const std::span<const double> all = lanes->readings_of(place);
    const std::vector<double>& ours = row->readings[ReadingModel::reading].values;
    return first + ours.size() > all.size() ||
           !std::equal(ours.begin(), ours.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
  };
  rows_.erase(std::find_if(rows_.begin(), rows_.end(), is_replaced), rows_.end());
}

/// Returns the first row that is not before a step.
StepReader::Rows::iterator StepReader::row_from(std::uint64_t step) {
  return std::lower_bound(rows_.begin(), rows_.end(), step,
                          [](const ComparedStepPtr& row, std::uint64_t number) { return row->step < number; });
}

/// Returns the readings of a step, from its row if it has one.
ComparedStepPtr StepReader::read_step(const Step& step, std::size_t sensor) {
  if (const auto row = row_from(step.step); row != rows_.end() && (*row)->step == step.step) return *row;
  return std::make_shared<const ComparedStep>(
      ComparedStep{step.step, step.time, step.travel, models_(view_of(step), sensor), false});
}

void StepReader::add_row(const Step& step, std::size_t sensor, const Trace* trace) {
  const auto place = row_from(step.step);
  if (place != rows_.end() && (*place)->step == step.step) return;
  ComparedStep row = *read_step(step, sensor);
  row.after_gap = place != rows_.begin() && trace != nullptr && skips_row(*trace, (*(place - 1))->time, step.time);
  rows_.insert(place, std::make_shared<const ComparedStep>(std::move(row)));
}

void StepReader::read(const ReadingsInput& input, ReadingsResult& out, Progress& progress) {
  const SimFrame& frame = *input.frame;
  const std::size_t sensor = at(input.request.sensor);
  out.generation = input.generation;
  out.recalled = input.recalled;
  out.request = input.request.second.value_or(ui::CompareRequest{});
  out.sensor = input.request.sensor;
  out.model = frame.scene->sensors[sensor];
  out.due = input.due;
  build(input, progress);
  out.equal_contact = equal_contact_;
  out.problem = problem_;
  if (!models_) return;
  if (second_) {
    out.b = second_->model();
    out.taxels_of_b = taxels_;
    out.reads_recorded = second_->reads_recorded();
  }
  if (generation_ != input.generation) drop_changed_rows(frame, sensor);
  generation_ = input.generation;
  const HistoryState& history = frame.history;
  const auto is_lost = [&](const ComparedStepPtr& row) {
    return row->step < history.first || row->step > history.last;
  };
  if (!second_) std::erase_if(rows_, is_lost);
  try {
    if (!second_) add_row(frame, sensor, nullptr);  // all steps that were displayed are part of the curves
    for (const StepPtr& step : input.recalled ? input.recalled->steps : std::vector<StepPtr>{}) {
      progress.stop_if_cancelled();
      if (step->scene == frame.scene) add_row(*step, sensor, frame.trace.get());
    }
    out.displayed = read_step(frame, sensor);
  } catch (const Error& error) {
    out.problem = shown_message(error);
  }
  out.steps = rows_;
}

namespace {

constexpr std::size_t kMaxSpread = 120;  // most steps that are spread over the history: a plot cannot show more
constexpr std::size_t kSpreadBatch = 6;  // steps copied at a time, and read before more are recalled
constexpr std::size_t kRowsBatch = 32;   // rows copied at a time

/// Returns whether a frame has a sensor with taxels.
bool is_readable(const SimFramePtr& frame, int sensor) {
  if (!frame || !frame->scene || at(sensor) >= frame->sensors.size() || at(sensor) >= frame->scene->sensors.size())
    return false;
  const SensorModel* model = frame->scene->sensors[at(sensor)].get();
  return model != nullptr && model->taxel_count() > 0;
}

/// Returns steps spread evenly over the recorded steps, including the newest step.
std::vector<std::uint64_t> spread_steps(const SimFrame& frame) {
  std::vector<std::uint64_t> spread;
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return spread;
  const std::size_t stride = (lanes->rows() + kMaxSpread - 1) / kMaxSpread;
  for (std::size_t row = (lanes->rows() - 1) % stride; row < lanes->rows(); row += stride)
    spread.push_back(lanes->steps[row].step);
  return spread;
}

}  // namespace

bool ReadingsInput::operator==(const ReadingsInput& other) const {
  return frame->id() == other.frame->id() && frame->history.first == other.frame->history.first &&
         request == other.request && generation == other.generation && recalled == other.recalled && due == other.due;
}

ReadingsJob::ReadingsJob(JobExecutor& executor)
    : slot_(executor, Priority::background,
            [reader = std::make_shared<StepReader>()](const ReadingsInput& input, ReadingsResult& out,
                                                      Progress& progress) { reader->read(input, out, progress); }) {}

ui::CompareProgress ReadingsJob::progress() const {
  return {slot_.busy() || !complete_, slot_.fraction(), read_, due_};
}

/// Begins a new generation, in which the steps are checked and read again, if the models, the run or recorded steps
/// have changed. Returns whether the request has changed.
bool ReadingsJob::begin_generation(const SimFrame& frame) {
  const HistoryLanes* lanes = frame.history.lanes.get();
  const ReadingsSubject subject{*request_, frame.scene, frame.runs, lanes != nullptr ? lanes->edition : 0};
  if (subject == subject_) return false;
  const bool is_other = !(subject.request == subject_.request);
  subject_ = subject;
  ++generation_;
  recalled_.reset();
  recalled_steps_.clear();
  requested_until_ = -std::numeric_limits<double>::infinity();
  read_ = 0;
  return is_other;
}

/// Returns the next of the spread steps that were neither displayed nor recalled.
std::vector<std::uint64_t> ReadingsJob::next_spread(const std::vector<std::uint64_t>& spread,
                                                    const ReadingsResult& result) {
  for (const ComparedStepPtr& step : result.steps) recalled_steps_.insert(step->step);
  std::vector<std::uint64_t> next;
  for (const std::uint64_t step : spread) {
    if (next.size() == kSpreadBatch) break;
    if (recalled_steps_.insert(step).second) next.push_back(step);
  }
  return next;
}

/// Returns the steps of the rows of the run after the rows that were read, as far as the history has them.
std::vector<std::uint64_t> ReadingsJob::next_rows(const SimFrame& frame, const ReadingsResult& result) {
  const std::vector<TraceRow>& trace = frame.trace->rows;
  const HistoryLanes& lanes = *frame.history.lanes;
  if (!result.steps.empty()) requested_until_ = std::max(requested_until_, result.steps.back()->time);
  auto row = std::upper_bound(trace.begin(), trace.end(), requested_until_,
                              [](double time, const TraceRow& r) { return time < r.time; });
  std::vector<std::uint64_t> next;
  for (; row != trace.end() && next.size() < kRowsBatch; ++row) {
    const StepMark* const mark = std::lower_bound(lanes.steps.begin(), lanes.steps.end(), row->time,
                                                  [](const StepMark& m, double time) { return m.time < time; });
    if (mark == lanes.steps.end()) break;  // the newest rows of the lanes may be missing
    if (mark->time == row->time) next.push_back(mark->step);
    requested_until_ = row->time;
  }
  read_ = static_cast<std::size_t>(row - trace.begin());
  return next;
}

std::optional<RecallCommand> ReadingsJob::follow(const SimFramePtr& frame, bool runs) {
  if (!request_ || !is_readable(frame, request_->sensor)) {
    slot_.post(std::nullopt, Superseded::cancel);
    complete_ = true;
    read_ = due_ = 0;
    return std::nullopt;
  }
  const bool reads_rows = request_->second.has_value();
  complete_ = complete_ || runs;
  if (runs && !reads_rows) return std::nullopt;  // the newest result stays
  const bool is_other = begin_generation(*frame);
  const std::vector<std::uint64_t> spread = reads_rows ? std::vector<std::uint64_t>{} : spread_steps(*frame);
  slot_.post(ReadingsInput{frame, *request_, generation_, awaits_reply_ ? nullptr : recalled_, spread.size()},
             is_other ? Superseded::cancel : Superseded::finish);
  due_ = frame->trace ? frame->trace->rows.size() : 0;
  const auto result = slot_.newest();
  const bool is_read = result && result->generation == generation_ && result->recalled == recalled_;
  const bool reads_more = (frame->trace || !reads_rows) && frame->history.lanes && !request_->stopped;
  complete_ = runs || !reads_more || (is_read && !result->problem.empty());
  if (awaits_reply_ || !is_read || !reads_more || !result->problem.empty()) return std::nullopt;
  RecallCommand next{reads_rows ? next_rows(*frame, *result) : next_spread(spread, *result),
                     reads_rows ? kCompareAsks : kModelsAsks};
  complete_ = complete_ || next.steps.empty();
  awaits_reply_ = !next.steps.empty();
  recall_generation_ = generation_;
  return awaits_reply_ ? std::optional(std::move(next)) : std::nullopt;
}

void ReadingsJob::accept(StepsRecalled recalled) {
  awaits_reply_ = false;
  if (recall_generation_ != generation_) return;  // the steps may be those of an earlier run
  recalled_ = std::make_shared<const StepsRecalled>(std::move(recalled));
}

namespace {

class ReadingsOfFeature : public RecallingJob<ReadingsJob, ui::ComparedLayoutsPtr> {
 public:
  using RecallingJob::RecallingJob;

 private:
  std::optional<RecallCommand> follow(ReadingsJob& job, const FollowedRun& run) final {
    return job.follow(run.frame, run.runs);
  }
};

class ModelsOfFeature final : public ReadingsOfFeature {
 public:
  explicit ModelsOfFeature(JobExecutor& executor) : ReadingsOfFeature(executor, kModelsAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    const auto wanted = ui::models_request(*app.viewer, *app.shown, ui::is_in_use(ui::kModels, app));
    if (!wanted) return job().end_request();
    job().request({wanted->sensor, {}, false});
  }
  void fill(ui::App& app) const override { app.get<ui::ModelsState>().compared = result(); }
};

class CompareOfFeature final : public ReadingsOfFeature {
 public:
  explicit CompareOfFeature(JobExecutor& executor) : ReadingsOfFeature(executor, kCompareAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    const auto& state = app.get<ui::CompareState>();
    auto second = ui::compare_request(*app.viewer, *app.shown, state, app.get<ui::PanelsShown>()[ui::kCompare]);
    const int sensor = app.viewer->selection.sensor;
    if (!second) return job().end_request();
    job().request({sensor, std::move(second), state.stopped});
  }
  void fill(ui::App& app) const override {
    app.get<ui::CompareState>().compared = result();
    app.get<ui::CompareState>().progress = job().progress();
  }
};

}  // namespace

std::unique_ptr<FeatureJob> make_models_job(JobExecutor& executor) {
  return std::make_unique<ModelsOfFeature>(executor);
}

std::unique_ptr<FeatureJob> make_compare_job(JobExecutor& executor) {
  return std::make_unique<CompareOfFeature>(executor);
}

}  // namespace taxel::studio
