// The worker thread that explains a reading: the newest question wins.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/features/explain/explain_state.h"
#include "app/studio/jobs/newest_wins.h"
#include "core/run/frame.h"
#include "core/sensor/explain/explainer.h"

namespace taxel::studio {

class ExplainWorker {
 public:
  /// `wake` is called from the worker when there is another answer.
  explicit ExplainWorker(std::function<void()> wake);

  /// The taxel in the step of `frame`, compared with the one before that the frame carries. Without a request or a
  /// frame: nothing any more.
  void explain(const SimFramePtr& frame, const std::optional<ui::ExplainRequest>& request);
  [[nodiscard]] ui::ExplainedPtr newest() const { return worker_.newest(); }
  void wait() { worker_.wait(); }
  [[nodiscard]] bool busy() const { return worker_.busy(); }

 private:
  struct Job {
    SimFramePtr frame;
    ui::ExplainRequest request;
    /// Frames are made anew when anything changes; what counts is what is explained.
    bool operator==(const Job& other) const;
  };
  ui::ExplainedPtr attempt(const Job& job, Progress& progress);

  Explainer explainer_;
  NewestWins<Job, ui::ExplainedStep> worker_;  // last: it ends first
};

}  // namespace taxel::studio
