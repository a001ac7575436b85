// Generates the preview of a pattern of taxels on a worker.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/layout/generators/pattern.h"

namespace taxel::studio {

struct PatternRequest {
  std::uint64_t number = 0;  ///< unique number of the request
  Pattern pattern;
  PatternSource source;
  std::shared_ptr<const MeshIndex> skin;
  bool operator==(const PatternRequest& other) const { return number == other.number; }
};

struct PatternResult {
  std::uint64_t number = 0;  ///< number of the request
  PatternTaxels made;
  std::string problem;  ///< reason for the failure, or empty
};
using PatternResultPtr = std::shared_ptr<const PatternResult>;

/// Returns the message for a value out of range, with the label and the unit that the panel displays.
std::string displayed_problem(const PatternFieldError& error);

class PatternJob : public NewestWins<PatternRequest, PatternResult> {
 public:
  explicit PatternJob(JobExecutor& executor);
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_pattern_job(JobExecutor& executor);

}  // namespace taxel::studio
