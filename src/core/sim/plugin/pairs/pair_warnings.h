// Warnings about the pairs of a body, each given once: contacts of MuJoCo that act as well, bodies behind the skin, and
// the warnings of the forces.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

/// Returns true if the bound of a pair's stiffest mode [1/s^2] has grown by a fiftieth since the last check, and at
/// every eighth call, and begins to count again.
bool is_step_check_due(PairChecks& checks, double bound);
/// Adds a warning about a pair of geoms, "the contact of geoms "A" and "B" ...", and sets its flag.
void warn_of_pair(const mjModel& m, BodyContacts& body, std::size_t pair, bool PairChecks::*given,
                  const std::string& text);
/// Retains the present state as sensed(), and warns of its pairs: of contacts of MuJoCo, and of bodies behind a skin.
void sense_and_warn(const mjModel& m, mjData& d, BodyContacts& body);

}  // namespace taxel
