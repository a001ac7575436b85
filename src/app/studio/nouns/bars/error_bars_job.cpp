// Measures error bars of the displayed step on a worker.
#include <memory>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "core/run/frame.h"
#include "core/run/step.h"
#include "core/sim/compare/error_bars.h"

namespace taxel::studio {
namespace {

struct ErrorBarsInput {
  SimFramePtr frame;
  /// Compares the step: frames are created again whenever anything changes.
  bool operator==(const ErrorBarsInput& other) const { return frame->id() == other.frame->id(); }
};

class ErrorBarsJob : public NewestWins<ErrorBarsInput, ui::MeasuredErrors> {
 public:
  explicit ErrorBarsJob(JobExecutor& executor);

  void request(bool on) { on_ = on; }
  /// Posts the displayed step. Nothing is measured if error bars are off or there is no step.
  void follow(const SimFramePtr& frame) {
    post(on_ && frame && frame->scene ? std::optional(ErrorBarsInput{frame}) : std::nullopt);
  }

 private:
  bool on_ = false;
};

/// The prepared measures of a scene, kept from step to step.
struct Prepared {
  std::shared_ptr<const SimScene> scene;
  std::unique_ptr<ErrorBars> errors;
};

void measure(Prepared& prepared, const SimFrame& frame, ui::MeasuredErrors& out, Progress& progress) {
  if (prepared.scene != frame.scene) {
    prepared.errors = std::make_unique<ErrorBars>(frame.scene, &progress);
    prepared.scene = frame.scene;
  }
  out.id = frame.id();
  const StepView view = view_of(frame);
  for (std::size_t s = 0; s < view.sensors.size(); ++s) {
    out.missing.push_back(prepared.errors->missing(s));
    out.bars.emplace_back();
    if (out.missing.back().empty()) out.bars.back() = prepared.errors->measure(view, s);
  }
}

}  // namespace

ErrorBarsJob::ErrorBarsJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal,
                 [prepared = std::make_shared<Prepared>()](const ErrorBarsInput& input, ui::MeasuredErrors& out,
                                                           Progress& progress) {
                   measure(*prepared, *input.frame, out, progress);
                 }) {}

namespace {

class ErrorBarsOfFeature final : public FeatureJob {
 public:
  explicit ErrorBarsOfFeature(JobExecutor& executor) : executor_(executor), bars_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    bars_.request(ui::shows_run(app.viewer->mode) && app.get<ui::ErrorBarsState>().on);
  }
  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& run,
                      const SendToSimulation& /*send*/) override {
    bars_.follow(run.frame);
    executor_.run_posted();
    return store(measured_, bars_.newest());
  }
  void fill(ui::App& app) const override { app.shown->run.errors = measured_; }
  [[nodiscard]] bool busy() const override { return bars_.busy(); }

 private:
  JobExecutor& executor_;
  ErrorBarsJob bars_;
  ui::MeasuredErrorsPtr measured_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_error_bars_job(JobExecutor& executor) {
  return std::make_unique<ErrorBarsOfFeature>(executor);
}

}  // namespace taxel::studio
