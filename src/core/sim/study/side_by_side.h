// Runs many simulations in parallel.
#pragma once

#include <functional>
#include <memory>

#include "core/base/progress.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Builds `count` simulators by make(i) and runs each by run(i, simulator). make() is called one at a time, because
/// MuJoCo's compiler must not run twice at once; run() is called in parallel, in as many threads as there are cores.
/// The result of run() must depend on i only, so that the number of threads changes no result. If make() returns null,
/// run() is not called for i. Exceptions of make() are passed on; run() may throw only Cancelled.
void run_side_by_side(int count, const std::function<std::unique_ptr<Simulator>(int)>& make,
                      const std::function<void(int, Simulator&)>& run, Progress& progress);

}  // namespace taxel
