// The report of a repair in words.
#pragma once

#include <string>

#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {

/// Writes the message of a step and raises its severity if it changed more than 1 % of the area.
void finish_step(RepairStep& step, const RepairReport& report);

/// Returns one problem per step, with its code and severity, for `file` at /mesh/file. Empty if nothing was changed.
Problems repair_problems(const RepairReport& report, const std::string& file);

/// Returns the report in one line: "repaired: 2 folded faces and 1 fin removed (14.2 mm\u00b2, 0.8 % of the area), no
/// vertex moved", with an area for each kind of change. Empty if nothing was changed.
std::string repair_summary(const RepairReport& report);

}  // namespace taxel
