// Measures error bars of the displayed step on a worker.
#pragma once

#include <functional>
#include <memory>

#include "app/studio/frame/measured_errors.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/run/frame.h"

namespace taxel::studio {

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

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_error_bars_job(JobExecutor& executor);

}  // namespace taxel::studio
