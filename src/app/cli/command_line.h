// Options and arguments of the commands, their rules, and the parsed command line of the program.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/cli/console.h"
#include "app/help/option_values.h"

namespace CLI {
class App;
}

namespace taxel::cli {

/// Exit statuses of the program.
inline constexpr int kDone = 0;
inline constexpr int kProblemsFound = 1;
inline constexpr int kBadInput = 2;

/// Runs a command whose options were parsed. Returns the exit status and throws Error for bad input.
using Run = std::function<int(Console&)>;

/// A rule for the text of an option's value.
struct Check {
  ValueRule problem;
  std::string text;  ///< follows the unit in --help; may be empty
};
/// The value must be a finite number greater than 0, a finite number of at least 0, or any finite number.
Check positive();
Check not_negative();
Check finite();
/// The value must be a whole number from 0 to 2^64 - 1.
Check whole_number();
/// The value must be a number greater than 0, as --help says.
Check positive_number();
/// The value must be a whole number from `low` to `high`.
Check in_range(int low, int high);
/// The value must be one of `words`.
Check one_of(const std::vector<std::string>& words);

/// The variable that receives the value of an option, or a function that is called with its text. A bool is a flag.
using OptionValue =
    std::variant<bool*, int*, double*, std::string*, std::optional<int>*, std::optional<double>*,
                 std::optional<std::uint64_t>*, std::vector<std::string>*, std::function<void(const std::string&)>>;

/// Everything about an option apart from its name, value and help.
struct OptionRules {
  std::string unit = {};  ///< word after the name in --help, such as "FILE"
  std::string text = {};  ///< replaces unit, rule and default in --help
  std::optional<Check> check = {};
  std::string default_text = {};  ///< default value in --help
  bool is_required = false;
  std::vector<std::string> needs = {};     ///< options that must be given as well
  std::vector<std::string> excludes = {};  ///< options that must not be given as well
};
/// The rules of an argument that must be given.
OptionRules required();

/// The options of one command.
class OptionList {
 public:
  explicit OptionList(CLI::App& app) : app_(app) {}
  /// Adds an option ("--out") or an argument ("FILE"). The variable must outlive the parsing. An option with a list of
  /// texts takes one text each time it is given; an argument with a list takes all that follow.
  void add(const std::string& name, const OptionValue& value, const std::string& help, const OptionRules& rules = {});
  /// Name of the command, for messages.
  [[nodiscard]] std::string command() const;

 private:
  CLI::App& app_;
};

/// One command of the program.
struct CommandSpec {
  const char* name;
  const char* text;     ///< purpose in one line, for --help
  const char* example;  ///< below the options in --help
  Run (*add)(OptionList& list);
};
/// All commands, in the order of --help.
const std::vector<CommandSpec>& commands();

/// A command line that was understood.
struct ParsedCommandLine {
  Run run;  ///< the chosen command, or a function that prints the text of --help or --version
  CommonOptions common;
};
/// Parses the arguments of main(). Throws Error for bad usage.
ParsedCommandLine parse_command_line(int argc, char** argv);

}  // namespace taxel::cli
