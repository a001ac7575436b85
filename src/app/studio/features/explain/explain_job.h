// Explains a reading on a worker.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/features/explain/explain_state.h"
#include "app/studio/jobs/newest_wins.h"
#include "core/run/command.h"
#include "core/run/frame.h"
#include "core/sensor/explain/explainer.h"

namespace taxel::studio {

struct ExplainInput {
  SimFramePtr frame;
  ui::ExplainRequest request;
  /// Compares the explained step: frames are created again whenever anything changes.
  bool operator==(const ExplainInput& other) const;
};

class ExplainJob : public NewestWins<ExplainInput, ui::ExplainedStep> {
 public:
  ExplainJob(JobExecutor& executor, std::function<void()> wake);

  /// Sets the taxel to explain in every displayed step. Without a request nothing is explained. `send` receives the
  /// command by which the simulation sends the previous step too, or no longer.
  void request(std::optional<ui::ExplainRequest> request, const std::function<void(SimCommand)>& send);
  void forget_request() { request_.reset(); }
  /// Posts the requested taxel in the step of `frame`. While `keeps_result`, the newest result stays.
  void follow(const SimFramePtr& frame, bool keeps_result) {
    if (!keeps_result || !request_) explain(frame, request_);
  }
  /// Posts the taxel in the step of `frame`, which is compared with the previous step that the frame carries. Without a
  /// request or a frame nothing is explained any more.
  void explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request);

 private:
  std::optional<ui::ExplainRequest> request_;
};

}  // namespace taxel::studio
