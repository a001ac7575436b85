#include "app/studio/shell/timing.h"

#include <algorithm>
#include <chrono>

#include "app/studio/host/jobs/inline_executor.h"
#include "app/studio/host/jobs/job_pool.h"
#include "core/sim/host/inline_sim.h"
#include "core/sim/host/sim_thread.h"

namespace taxel::studio {

double RealClock::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double RealClock::duration(double measured) const {
  constexpr double kMinDuration = 1e-4;  // [s] ImGui needs a positive one
  return std::max(kMinDuration, measured);
}

Timing make_timing(const Options& options) {
  if (options.is_real_time())
    return {std::make_unique<RealClock>(), std::make_unique<JobPool>(), std::make_unique<SimThread>(), true};
  return {std::make_unique<ScriptClock>(), std::make_unique<InlineExecutor>(), std::make_unique<InlineSim>(), false};
}

}  // namespace taxel::studio
