// Finds the other declared bodies of an mjData. The plugin table, which holds their instances, defines these functions.
#pragma once

#include <mujoco/mujoco.h>

#include "core/sim/plugin/pairs/declared_bodies.h"

namespace taxel {

class BodyContacts;

/// Returns a declared body in `d`. Returns null if its instance is not of this library, or if `d` is a bitwise copy (as
/// pickling makes) whose bodies are in another mjData.
BodyContacts* find_body(const mjData& d, BodyId id);

/// Returns a declared body in `d`, and builds it first if `d` is a bitwise copy. Throws Error.
BodyContacts& own_body(const mjModel& m, mjData& d, BodyId id);

}  // namespace taxel
