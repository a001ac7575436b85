// The text of --help, laid out by this program because versions of CLI11 lay it out differently, and the options --man
// and --completion.
#pragma once

#include <string>

#include "app/help/program_help.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace taxel {

/// Lays out --help of a program, and of the commands that are added to it later.
void use_help_formatter(CLI::App& program);

/// Returns the text after an option's name in --help: unit, rule and default, whether it is required, and the options
/// that it needs or excludes. Empty, or with a space in front.
std::string option_suffix(const CLI::Option& option);

/// Returns the options and commands of a parser.
ProgramHelp describe_program(const CLI::App& app, const std::string& version);

/// Text that the program prints instead of running, thrown by the options below while the command line is parsed.
struct HelpText {
  std::string text;
};
/// Adds --man and --completion SHELL, which throw HelpText.
void add_help_options(CLI::App& app, const std::string& version);

}  // namespace taxel
