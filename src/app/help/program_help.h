// The options and commands of a program as values, for its manual page and for shells.
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

}  // namespace taxel
