#include "core/sim/sim_command.h"

namespace taxel {

SimCommand::SimCommand(const SimCommand&) = default;
SimCommand& SimCommand::operator=(const SimCommand&) = default;
SimCommand::SimCommand(SimCommand&&) noexcept = default;
SimCommand& SimCommand::operator=(SimCommand&&) noexcept = default;
SimCommand::~SimCommand() = default;

}  // namespace taxel
