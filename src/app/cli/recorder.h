// Runs a simulator and records its rows.
#pragma once

#include "app/cli/console.h"
#include "app/cli/kept_run.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

/// Number of steps, simulated time and computing time of a run.
struct RunCost {
  long steps = 0;
  double simulated = 0;  ///< simulated time [s]
  double wall = 0;       ///< wall time of all steps and rows [s]
  SensorTimes sensors;   ///< parts of `wall`; MuJoCo and the recording used the rest
  double cpu = 0;        ///< processor time of all steps and rows [s]
};

/// Follows the steps of a simulator. Throws Error if the recording is too large or contains a number that is not
/// finite.
class CheckedRecorder {
 public:
  /// Begins before the first step, or within it. `seconds` as in record(). Prints a note for a large recording.
  /// `errors`, which may be null, measures error bars.
  CheckedRecorder(const SimScene& scene, double seconds, Console& console,
                  std::shared_ptr<ErrorBarSource> errors = nullptr);
  void follow(const Simulator& simulator);
  [[nodiscard]] const Recording& recording() const { return recorder_.recording(); }
  [[nodiscard]] Recording take() { return recorder_.take(); }

 private:
  RunRecorder recorder_;
  StepView view_;
  long steps_ = 0;
};

/// Steps until the scenario or `seconds` of simulated time have ended, or a signal is received (signals.h), and records
/// all rows that are due. There is no limit if `seconds` is 0. `kept`, which may be null, writes the rows to disk
/// meanwhile. `errors`, which may be null, measures error bars. Throws the errors of CheckedRecorder.
Recording record(Simulator& simulator, double seconds, Console& console, RunCost& cost, KeptRun* kept = nullptr,
                 std::shared_ptr<ErrorBarSource> errors = nullptr);

/// Returns the error bars of a scene, and warns of each sensor with taxels that has none.
std::shared_ptr<ErrorBarSource> error_bars_of(const Simulator& simulator, Console& console);

}  // namespace taxel::cli
