// The options --man and --completion of a program.
#pragma once

#include <string>

#include "app/help/program_help.h"

namespace CLI {
class App;
}

namespace taxel {

/// Returns the options and commands of a parser.
ProgramHelp describe_program(const CLI::App& app, const std::string& version);

/// Text that the program prints instead of running, thrown by the options below while the command line is parsed.
struct HelpText {
  std::string text;
};
/// Adds --man and --completion SHELL, which throw HelpText.
void add_help_options(CLI::App& app, const std::string& version);

}  // namespace taxel
