// The options and commands of a program as values, its manual page, and scripts with which shells complete its command
// line.
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// One option or argument.
struct OptionHelp {
  std::vector<std::string> names;  ///< "-h" and "--help"; empty for an argument
  std::string value;               ///< name of the argument, or text behind the option in --help; may be empty
  std::string text;                ///< purpose
  std::vector<std::string> words;  ///< all valid values if they are known words, otherwise empty
  bool takes_value = false;        ///< whether a word follows the option
};

/// A program without commands, or one command.
struct CommandHelp {
  std::string name;
  std::string text;    ///< purpose
  std::string footer;  ///< lines below the options in --help
  std::vector<OptionHelp> options;
};

struct ProgramHelp {
  CommandHelp program;
  std::vector<CommandHelp> commands;
  std::string version;
};

/// Returns the manual page of a program in the language of troff, with one section for each command.
std::string man_page(const ProgramHelp& help);

/// Returns the words that completion_script() accepts: bash, fish and zsh.
std::vector<std::string> completion_shells();

/// Returns a script that completes commands, options and the words that an option accepts. Everything else is completed
/// as a file name. `shell` is one of completion_shells().
std::string completion_script(const ProgramHelp& help, const std::string& shell);

}  // namespace taxel
