// Reads the recorded steps with other sensor models on a worker, a few steps at a time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/models/models_state.h"
#include "core/run/command.h"
#include "core/run/event.h"

namespace taxel::studio {

/// RecallCommand::asker of this job.
inline constexpr int kModelsAsks = 0;

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

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_models_job(JobExecutor& executor);

}  // namespace taxel::studio
