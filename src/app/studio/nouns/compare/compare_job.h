// Reads the recorded steps with a second layout on a worker, a few steps at a time, also while the simulation runs.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/compare/layout_reader.h"
#include "core/run/command.h"

namespace taxel::studio {

/// RecallCommand::asker of this job.
inline constexpr int kCompareAsks = 1;

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

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_compare_job(JobExecutor& executor);

}  // namespace taxel::studio
