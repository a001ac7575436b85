// Converts a recorded run to a path around the object of the run.
#pragma once

#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// Returns `edited` as a path through `points`, poses in the world of a run of the scenario `run`. The object is that
/// of `edited`, or that of the run if `edited` has none because it is the paper's demo. The box of the demo (kDemoBox)
/// is at another place than the boxes of other kinds, so the points of a run of the demo move together with the box:
/// the finger touches the box at the same points.
Scenario path_of_run(Scenario edited, const Scenario& run, std::vector<WayPoint> points);

}  // namespace taxel
