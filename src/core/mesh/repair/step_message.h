// The steps of a repair in words.
#pragma once

#include "core/mesh/repair/repair.h"

namespace taxel {

/// Writes the message of a step and raises its severity if it changed more than 1 % of the area.
void finish_step(RepairStep& step, const RepairReport& report);

}  // namespace taxel
