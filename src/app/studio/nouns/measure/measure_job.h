// Measures distances on the skin on a worker: on a large mesh a geodesic path takes longer than a frame.
#pragma once

#include <functional>
#include <memory>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "ui/scene/measured.h"

namespace taxel::studio {

class MeasureJob : public NewestWins<ui::MeasureRequest, ui::Measured> {
 public:
  explicit MeasureJob(JobExecutor& executor);
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_measure_job(JobExecutor& executor);

}  // namespace taxel::studio
