// Values of options, read and refused in words of this program, and messages for a refused command line: versions of
// CLI11 read numbers differently and word their messages differently.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace taxel {

/// Returns the number that a whole text is in decimal notation, or nothing if the text is no finite number.
std::optional<double> finite_number(const std::string& text);

/// Returns the whole number that a whole text is, or nothing if the text is none or the number is too large.
std::optional<int> small_number(const std::string& text);
std::optional<std::uint64_t> natural_number(const std::string& text);

/// Rule for the text of a value: returns a message, or an empty text if the value is valid.
using ValueRule = std::function<std::string(const std::string&)>;

/// Returns the rule that a value is one of these words, and how --help shows the words: "{mean,max}".
ValueRule one_of_words(const std::vector<std::string>& words);
std::string list_of_words(const std::vector<std::string>& words);

/// Makes an option refuse values that break a rule: parsing throws Error with the command, the option and the message.
/// `text` follows the unit in --help and may be empty.
void add_rule(CLI::Option& option, const CLI::App& command, const ValueRule& rule, const std::string& text);

/// Adds an option with a number. Parsing throws Error for a value that is no number. The variable must outlive the
/// parsing.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, int& target, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<int>& target, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target,
                        const std::string& help);

/// Returns why a command line was refused, on one line, after a parse that threw `error`. `app` is the command that was
/// recognised, or the program. `words` are the arguments of main() without the program's name.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words);

}  // namespace taxel
