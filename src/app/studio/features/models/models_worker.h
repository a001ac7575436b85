// The worker thread that reads the recorded steps by other models, some at a time.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/studio/features/models/models_state.h"
#include "app/studio/jobs/newest_wins.h"
#include "core/run/command.h"
#include "core/run/frame.h"
#include "core/sim/compare/model_comparison.h"

namespace taxel::studio {

class ModelsWorker {
 public:
  /// `wake` is called from the worker when there are more steps.
  explicit ModelsWorker(std::function<void()> wake);

  /// What is asked for; none: nothing any more.
  void compare(std::optional<ui::ModelsRequest> request) { wish_ = request; }
  /// Reads the step that is shown, and what was recalled since; `runs`: what there is stays until the simulation
  /// stands. Returns what is to be asked of it next.
  std::optional<RecallCommand> follow(const SimFramePtr& frame, bool runs);
  [[nodiscard]] ui::ComparedPtr newest() const;
  void wait() { worker_.wait(); }
  /// More will come without anybody's doing.
  [[nodiscard]] bool busy() const { return worker_.busy() || (wish_ && !complete_); }

 private:
  struct Job {
    SimFramePtr frame;
    int sensor = 0;
    std::uint64_t generation = 0;
    std::shared_ptr<const RecalledSteps> recalled;
    std::size_t due = 0;
    /// Frames are made anew when anything changes; what counts is the step.
    bool operator==(const Job& other) const;
  };
  struct Result {
    ui::ComparedPtr shown;
    std::uint64_t generation = 0, recalled = 0;  ///< number of the command whose steps are among them
  };
  std::shared_ptr<const Result> attempt(const Job& job, Progress& progress);
  void add(const Step& step);
  void forget_what_changed(const SimFrame& frame, int sensor);

  std::optional<ui::ModelsRequest> wish_;
  std::shared_ptr<const SimScene> scene_;  // of this generation
  std::uint64_t run_ = 0;                  // likewise, as SimFrame::runs
  int sensor_ = -1;
  std::uint64_t generation_ = 0, recall_ = 0;  // number of the last command
  std::set<std::uint64_t> asked_;              // steps of this generation
  bool complete_ = true;

  // the worker's own
  std::unique_ptr<ModelComparison> comparison_;
  std::uint64_t known_generation_ = 0;
  std::map<std::uint64_t, ui::ComparedStep> known_;

  NewestWins<Job, Result> worker_;  // last: it ends first
};

}  // namespace taxel::studio
