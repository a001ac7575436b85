// A recorded run as a scenario of its own: the poses become way points of a path, around the object of the run.
#pragma once

#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// Returns `edited` as a path through `points`, poses in the world of a run of the scenario `run`. The object stays
/// that of `edited`; that of the run takes its place if `edited` has none, being the paper's demo. The box of this demo
/// (kDemoBox) is not where scenarios of other kinds have their boxes, so the points of a run of the demo move
/// together with the box: the finger touches the box where it did.
Scenario path_of_run(Scenario edited, const Scenario& run, std::vector<WayPoint> points);

}  // namespace taxel
