// The worker thread that runs parameter studies.
#pragma once

#include <functional>

#include "app/studio/features/study/study_state.h"
#include "app/studio/jobs/newest_wins.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

struct StudyJob {
  ui::StudyRequest request;
  SensorModelPtr model;  ///< of the layout that is studied
  bool operator==(const StudyJob& other) const { return request == other.request; }
};

class StudyWorker {
 public:
  /// `wake` is called from the worker when it is done.
  explicit StudyWorker(std::function<void()> wake);

  /// None: what runs is cancelled, and nothing is shown any more.
  void ask(std::optional<StudyJob> job) { worker_.ask(std::move(job)); }
  [[nodiscard]] StudyCurvesPtr newest() const { return worker_.newest(); }
  [[nodiscard]] bool busy() const { return worker_.busy(); }
  [[nodiscard]] double fraction() const { return worker_.fraction(); }
  void wait() { worker_.wait(); }

 private:
  NewestWins<StudyJob, StudyCurves> worker_;
};

}  // namespace taxel::studio
