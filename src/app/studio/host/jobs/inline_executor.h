// Runs jobs on the thread of the caller in the order in which they were posted, so that a script always sees the same.
#pragma once

#include <vector>

#include "app/studio/host/jobs/job_executor.h"

namespace taxel::studio {

/// Belongs to one thread.
class InlineExecutor final : public JobExecutor {
 public:
  [[nodiscard]] bool busy() const override { return !queue_.empty(); }
  void post(const void* slot, Priority priority, std::function<void()> task, int frames = 0) override;
  void remove(const void* slot) override;
  void begin_frame(bool without_delay) override;
  void run_posted() override;

 private:
  struct Task {
    const void* slot;
    std::function<void()> run;
    int frames_left;  ///< number of frames to begin before the task runs
  };

  std::vector<Task> queue_;
};

}  // namespace taxel::studio
