// Explains a reading on a worker.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "core/run/command.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sensor/explain/explainer.h"

namespace taxel::studio {

/// RecallCommand::asker of this job.
inline constexpr int kExplainAsks = 2;

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

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_explain_job(JobExecutor& executor);

}  // namespace taxel::studio
