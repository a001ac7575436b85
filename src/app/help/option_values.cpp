#include "app/help/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

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

}  // namespace taxel
