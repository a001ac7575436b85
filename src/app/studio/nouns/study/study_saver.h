// Writes the displayed study as a data set, on a worker.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/study/study_job.h"

namespace taxel::studio {

struct StudySave {
  ui::StudySaveRequest request;
  StudyInput input;  ///< the study that is displayed
  bool operator==(const StudySave& other) const { return request == other.request; }
};

struct SavedStudy {
  std::string folder;
  std::string text;     ///< a sentence for the user
  std::string problem;  ///< why the data set was not written, or empty
};

class StudySaver : public NewestWins<StudySave, SavedStudy> {
 public:
  explicit StudySaver(JobExecutor& executor);

  /// Begins to write `input`, unless that was requested before. Without a request the writing is cancelled.
  void request(const std::optional<ui::StudySaveRequest>& request, const std::optional<StudyInput>& input);
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_study_job(JobExecutor& executor);

}  // namespace taxel::studio
