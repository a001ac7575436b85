#include "app/help/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text/words.h"

namespace taxel {
namespace {

/// Returns the value of a whole text, or nothing. A plus sign is allowed.
template <class T>
std::optional<T> value_of(const std::string& text) {
  T value{};
  const char* begin = text.data();
  const char* const end = begin + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string name_for_messages(const CLI::App& command) {
  return command.get_parent() == nullptr ? "" : command.get_name();
}

/// Adds an option whose value is read by `read`. An empty value changes nothing: the caller refuses it.
template <class Target, class Read>
CLI::Option* add_read(CLI::App& app, const std::string& name, Target& target, const std::string& help, const Read& read,
                      const char* type, const char* expected) {
  const auto consume = [&app, &target, name, read, expected](const std::string& text) {
    if (text.empty()) return;
    const auto value = read(text);
    if (!value) throw Error(name_for_messages(app), name, fmt::format("must be {}, is {}", expected, text));
    target = *value;
  };
  return app.add_option_function<std::string>(name, consume, help)->type_name(type);
}

constexpr const char* kNumber = "a finite number";
constexpr const char* kSmall = "a whole number of at most 31 bits";
constexpr const char* kNatural = "a whole number from 0 to 2^64 - 1";

}  // namespace

std::optional<double> finite_number(const std::string& text) {
  const std::optional<double> value = value_of<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> small_number(const std::string& text) {
  return value_of<int>(text);
}

std::optional<std::uint64_t> natural_number(const std::string& text) {
  return value_of<std::uint64_t>(text);
}

ValueRule one_of_words(const std::vector<std::string>& words) {
  return [words](const std::string& text) {
    const bool is_known = std::find(words.begin(), words.end(), text) != words.end();
    return is_known ? std::string() : fmt::format("must be one of {}, is {}", fmt::join(words, ", "), text);
  };
}

std::string list_of_words(const std::vector<std::string>& words) {
  return fmt::format("{{{}}}", fmt::join(words, ","));
}

void add_rule(CLI::Option& option, const CLI::App& command, const ValueRule& rule, const std::string& text) {
  const auto refuse = [rule, &option, &command](const std::string& value) {
    if (value.starts_with("--"))  // CLI11 takes the next word as the value, an option as well
      throw Error(name_for_messages(command), option.get_name() + " needs a value");
    const std::string problem = rule(value);
    if (!problem.empty()) throw Error(name_for_messages(command), option.get_name(), problem);
    return std::string();
  };
  option.check(CLI::Validator(refuse, text));
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const std::string& help) {
  return add_read(app, name, target, help, finite_number, "FLOAT", kNumber);
}
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const std::string& help) {
  return add_read(app, name, target, help, finite_number, "FLOAT", kNumber);
}
CLI::Option* add_number(CLI::App& app, const std::string& name, int& target, const std::string& help) {
  return add_read(app, name, target, help, small_number, "INT", kSmall);
}
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<int>& target, const std::string& help) {
  return add_read(app, name, target, help, small_number, "INT", kSmall);
}
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target,
                        const std::string& help) {
  return add_read(app, name, target, help, natural_number, "UINT", kNatural);
}

namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// Returns the option that a word names, alone or in front of "=VALUE"; null if it names none.
const CLI::Option* option_of(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  if (name.size() < 2 || name[0] != '-') return nullptr;
  return app.get_option_no_throw(name);
}

/// Returns the message for a word that is neither a command nor an option. It names the one that the word resembles.
std::string message_of_unknown(const CLI::App& app, const std::string& word, bool is_command) {
  std::vector<std::string> names;
  if (is_command)
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(command->get_name());
  if (word.starts_with('-'))
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::vector<std::string_view> words(names.begin(), names.end());
  return fmt::format("unknown {} {}{}", is_command && !word.starts_with('-') ? "command" : "argument", word,
                     meant_word(word.substr(0, word.find('=')), words));
}

std::string message_of_missing(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    if (option->get_required() && option->count() == 0) return option->get_name() + " is required";
  return "";
}

/// Returns the message for options that must be given together, or must not be.
std::string message_of_pairs(const CLI::App& app) {
  const std::vector<const CLI::Option*> options = app.get_options();
  const auto given = [](const CLI::Option* option) { return option->count() > 0; };
  for (const CLI::Option* option : options) {
    if (!given(option)) continue;
    const std::set<CLI::Option*> needs = option->get_needs(), excludes = option->get_excludes();
    for (const CLI::Option* other : options) {  // in the order of --help
      auto* const key = const_cast<CLI::Option*>(other);
      if (needs.contains(key) && !given(other))
        return fmt::format("{} requires {}", option->get_name(), other->get_name());
      if (excludes.contains(key) && given(other))
        return fmt::format("{} excludes {}", option->get_name(), other->get_name());
    }
  }
  return "";
}

/// Returns the message for an option without its value, a flag with a value, or an option that is repeated.
std::string message_of_values(const CLI::App& app, const std::vector<std::string>& words) {
  for (const CLI::Option* option : app.get_options())
    if (const std::size_t count = option->count(); count > 1 && option->get_items_expected_max() == 1)
      return fmt::format("{} must be given once, is given {} times", option->get_name(), count);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const CLI::Option* const option = option_of(app, words[i]);
    if (option == nullptr) continue;
    const std::size_t equals = words[i].find('=');
    if (!takes_value(*option) && equals != std::string::npos)
      return fmt::format("{} takes no value, is given {}", option->get_name(), words[i].substr(equals + 1));
    const bool is_last =
        i + 1 == words.size() || words[i + 1].starts_with("--") || option_of(app, words[i + 1]) != nullptr;
    const bool is_empty = equals == std::string::npos ? is_last : equals + 1 == words[i].size();
    if (takes_value(*option) && is_empty) return fmt::format("{} needs a value", option->get_name());
  }
  return "";
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  const bool has_commands = !app.get_subcommands([](const CLI::App*) { return true; }).empty();
  const std::vector<std::string> unknown = app.remaining();
  if (!unknown.empty()) return message_of_unknown(app, unknown.front(), has_commands);
  const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
  std::string message;
  if (is(CLI::ExitCodes::ExtrasError)) {
    const auto mark = std::find(words.begin(), words.end(), "--");  // all words behind it are arguments
    if (mark != words.end() && mark + 1 != words.end()) message = "unknown argument " + mark[1];
  }
  if (is(CLI::ExitCodes::RequiredError))
    message = has_commands ? fmt::format("a command is required; `{} --help` lists them", app.get_name())
                           : message_of_missing(app);
  if (is(CLI::ExitCodes::RequiresError) || is(CLI::ExitCodes::ExcludesError)) message = message_of_pairs(app);
  if (is(CLI::ExitCodes::ArgumentMismatch) || is(CLI::ExitCodes::ConversionError) || is(CLI::ExitCodes::InvalidError))
    message = message_of_values(app, words);
  return message.empty() ? "the options cannot be understood; --help lists them" : message;
}

}  // namespace taxel
