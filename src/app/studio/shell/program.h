// The program taxelstudio as a function, which main() calls, and tests that run many scripts in one process.
#pragma once

namespace taxel {
class SensorCache;
}

namespace taxel::studio {

/// Runs the program with the arguments of main(), and returns its exit status: 0, 2 after an error, which is written to
/// stderr, or 128 and the signal's number if a signal ended the program. `cache` has the parts of sensors that earlier
/// runs compiled.
int run_program(int argc, char** argv, SensorCache& cache);

}  // namespace taxel::studio
