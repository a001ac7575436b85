#include "app/studio/frame/command.h"

namespace taxel::ui {

Command::Command(const Command&) = default;
Command& Command::operator=(const Command&) = default;
Command::Command(Command&&) noexcept = default;
Command& Command::operator=(Command&&) noexcept = default;
Command::~Command() = default;

}  // namespace taxel::ui
