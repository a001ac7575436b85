// The text of --help, laid out by this program: versions of CLI11 lay it out differently.
#pragma once

#include <string>

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

}  // namespace taxel
