// Commands of the simulation as commands of the window.
#pragma once

#include "core/run/command.h"

namespace taxel::studio {

struct Host;

/// Sends a command of the user to the simulation. One about the scene is dropped if there is none.
void carry_out(const SimCommand& command, Host& host);

}  // namespace taxel::studio
