// Scripts with which shells complete the command line of a program.
#pragma once

#include <string>
#include <vector>

#include "app/help/program_help.h"

namespace taxel {

/// Returns the words that completion_script() accepts: bash, fish and zsh.
std::vector<std::string> completion_shells();

/// Returns a script that completes commands, options and the words that an option accepts. Everything else is completed
/// as a file name. `shell` is one of completion_shells().
std::string completion_script(const ProgramHelp& help, const std::string& shell);

}  // namespace taxel
