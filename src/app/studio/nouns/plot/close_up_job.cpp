// Computes the exact readings of a taxel in the steps of a close-up on a worker.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/plot/close_up.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/base/math.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sensor/readout/reading.h"

namespace taxel::studio {
namespace {

/// RecallCommand::asker of this job.
constexpr int kCloseUpAsks = 3;

/// The steps of a close-up in one run.
struct CloseUpSteps {
  ui::PlotCloseUp of;
  bool by_travel = false;
  std::shared_ptr<const SimScene> scene;
  std::uint64_t runs = 0, edition = 0;  ///< run, and edition of its rows
  StepRange steps;
  bool operator==(const CloseUpSteps&) const = default;
};

struct CloseUpInput {
  CloseUpSteps about;
  std::vector<StepPtr> steps;
  bool operator==(const CloseUpInput& other) const { return about == other.about && steps == other.steps; }
};

void read_exactly(const CloseUpInput& input, ui::ExactCurve& out, Progress& progress) {
  const CloseUpSteps& about = input.about;
  const std::size_t sensor = at(about.of.key.sensor);
  const SensorModel& model = *about.scene->sensors[sensor];
  const int taxel = ui::index_of(model.layout, about.of.key.id);
  out.of = about.of;
  out.scene = about.scene;
  out.by_travel = about.by_travel;
  for (const StepPtr& step : input.steps) {
    progress.stop_if_cancelled();
    const ExactReading exact = exact_reading(model, taxel, surface_pointers(step->sensors[sensor]));
    out.problem = exact.missing;
    if (!exact.value) return;
    out.curve.x.push_back(about.by_travel ? 1e3 * step->travel : step->time);
    out.curve.readings.push_back(*exact.value);
  }
}

class CloseUpJob {
 public:
  explicit CloseUpJob(JobExecutor& executor) : slot_(executor, Priority::background, read_exactly) {}

  void request(std::optional<ui::PlotCloseUp> close_up, bool by_travel) {
    request_ = close_up;
    by_travel_ = by_travel;
  }
  /// Returns the command that recalls the steps of the close-up, once for each run and close-up.
  std::optional<RecallCommand> follow(const SimFramePtr& frame, bool runs);
  /// Accepts the reply to the command that follow() returned last.
  void accept(StepsRecalled recalled);
  [[nodiscard]] ui::ExactCurvePtr newest() const { return slot_.newest(); }
  [[nodiscard]] bool busy() const { return slot_.busy() || awaits_reply_; }

 private:
  std::optional<ui::PlotCloseUp> request_;
  bool by_travel_ = false;
  std::optional<CloseUpSteps> about_;  ///< steps that were requested last
  bool awaits_reply_ = false;
  NewestWins<CloseUpInput, ui::ExactCurve> slot_;
};

std::optional<RecallCommand> CloseUpJob::follow(const SimFramePtr& frame, bool runs) {
  if (awaits_reply_ || runs) return std::nullopt;
  const HistoryLanes* lanes = frame ? frame->history.lanes.get() : nullptr;
  const std::size_t sensor = request_ ? at(request_->key.sensor) : 0;
  const bool is_readable = request_ && lanes != nullptr && lanes->rows() > 0 && frame->scene &&
                           sensor < frame->scene->sensors.size() && frame->scene->sensors[sensor] &&
                           ui::index_of(frame->scene->sensors[sensor]->layout, request_->key.id) >= 0;
  if (!is_readable) {
    about_.reset();
    slot_.post(std::nullopt, Superseded::cancel);
    return std::nullopt;
  }
  const CloseUpSteps about{*request_,   by_travel_,     frame->scene,
                           frame->runs, lanes->edition, ui::close_up_steps(*lanes, *request_)};
  if (about_ == about) return std::nullopt;
  about_ = about;
  awaits_reply_ = true;
  RecallCommand recall{{}, kCloseUpAsks};
  for (std::uint64_t step = about.steps.first; step <= about.steps.last; ++step) recall.steps.push_back(step);
  return recall;
}

void CloseUpJob::accept(StepsRecalled recalled) {
  awaits_reply_ = false;
  if (!about_) return;
  std::erase_if(recalled.steps, [&](const StepPtr& step) { return step->scene != about_->scene; });
  slot_.post(CloseUpInput{*about_, std::move(recalled.steps)}, Superseded::cancel);
}

class CloseUpOfFeature final : public RecallingJob<CloseUpJob, ui::ExactCurvePtr> {
 public:
  explicit CloseUpOfFeature(JobExecutor& executor) : RecallingJob(executor, kCloseUpAsks) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    const bool is_drawn = app.viewer->mode != ui::Mode::layout && app.get<ui::PanelsShown>()[ui::kPlot];
    job().request(is_drawn ? app.get<ui::PlotState>().close_up : std::nullopt, app.shown->run.by_travel());
  }
  void fill(ui::App& app) const override { app.get<ui::PlotState>().exact = result(); }
  void drop_scene() override { job().request(std::nullopt, false); }

 private:
  std::optional<RecallCommand> follow(CloseUpJob& job, const FollowedRun& run) override {
    return job.follow(run.frame, run.runs);
  }
};

}  // namespace

std::unique_ptr<FeatureJob> make_close_up_job(JobExecutor& executor) {
  return std::make_unique<CloseUpOfFeature>(executor);
}

}  // namespace taxel::studio
