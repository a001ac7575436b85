// Manual pages.
#pragma once

#include <string>

#include "app/help/program_help.h"

namespace taxel {

/// Returns the manual page of a program in the language of troff, with one section for each command.
std::string man_page(const ProgramHelp& help);

}  // namespace taxel
