// Runs parameter studies on a worker.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

struct StudyInput {
  ui::StudyRequest request;
  SensorModelPtr model;  ///< model of the studied layout
  bool operator==(const StudyInput& other) const { return request == other.request; }
};

class StudyJob : public NewestWins<StudyInput, StudyCurves> {
 public:
  explicit StudyJob(JobExecutor& executor);

  /// Runs a study of the layout of `model`. Without a request the study is cancelled.
  void request(const std::optional<ui::StudyRequest>& request, const SensorModelPtr& model);
};

}  // namespace taxel::studio
