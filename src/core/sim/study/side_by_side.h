// Many simulations at once.
#pragma once

#include <functional>
#include <memory>

#include "core/base/progress.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Makes `count` simulators by make(i), one after the other, since MuJoCo's compiler is not to be called twice at once,
/// and runs them by run(i, simulator) side by side, as many at a time as there are cores. What run() makes of i depends
/// on nothing else, so the number of threads changes no result. Where make() returns none, nothing runs; what it throws
/// goes on; run() must throw nothing but Cancelled.
void run_side_by_side(int count, const std::function<std::unique_ptr<Simulator>(int)>& make,
                      const std::function<void(int, Simulator&)>& run, Progress& progress);

}  // namespace taxel
