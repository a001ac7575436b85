// Runs a simulator and keeps what a recording holds.
#pragma once

#include "app/cli/console.h"
#include "app/cli/kept_run.h"
#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

/// What a run cost, and how far it went.
struct RunCost {
  long steps = 0;
  double simulated = 0;  ///< [s]
  double wall = 0;       ///< spent in steps and rows [s]
  SensorTimes sensors;   ///< parts of `wall`; the rest is MuJoCo's and the recording's
  double cpu = 0;        ///< the same as processor time: what remains on a machine that is busy otherwise [s]
};

/// Steps until the scenario is over or `seconds` (0: no limit) have passed, and records every row that is due. A signal
/// (signals.h) ends the run as well.
/// `kept` (may be null) keeps the rows on disk meanwhile.
Recording record(Simulator& simulator, double seconds, Console& console, RunCost& cost, KeptRun* kept = nullptr);

}  // namespace taxel::cli
