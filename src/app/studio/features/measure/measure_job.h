// Measures distances on the skin on a worker: on a large mesh a geodesic path takes longer than a frame.
#pragma once

#include <functional>

#include "app/studio/jobs/newest_wins.h"
#include "ui/scene/measured.h"

namespace taxel::studio {

class MeasureJob : public NewestWins<ui::MeasureRequest, ui::Measured> {
 public:
  explicit MeasureJob(JobExecutor& executor);
};

}  // namespace taxel::studio
