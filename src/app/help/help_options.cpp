#include "app/help/help_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

#include "app/help/option_values.h"
#include "app/help/program_help.h"

namespace taxel {
namespace {

constexpr std::size_t kColumn = 30;  // column of the explanations

/// Returns a name and its explanation. A long name has a line of its own.
std::string entry(const std::string& name, const std::string& text) {
  std::string out = fmt::format("  {:<{}}", name, kColumn - 2);
  if (text.empty()) return out + "\n";
  const std::string indent(kColumn, ' ');
  if (name.size() + 2 >= kColumn) out += "\n" + indent;
  for (const char c : text) {
    out += c;
    if (c == '\n') out += indent;
  }
  return out + "\n";
}

bool is_argument(const CLI::Option& option) {
  return option.get_positional();
}

bool is_list(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string usage(const CLI::App& app, const std::string& name) {
  std::string out = "Usage: " + name + " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!is_argument(*option)) continue;
    const std::string argument = option->get_name(true) + (is_list(*option) ? "..." : "");
    out += option->get_required() ? " " + argument : " [" + argument + "]";
  }
  if (!app.get_subcommands([](const CLI::App*) { return true; }).empty()) out += " SUBCOMMAND";
  return out + "\n";
}

/// Returns the arguments or the options of a command; empty if it has none.
std::string section(const CLI::App& app, const std::string& title, bool arguments) {
  std::string out;
  for (const CLI::Option* option : app.get_options())
    if (is_argument(*option) == arguments)
      out += entry(option->get_name(arguments, !arguments) + option_suffix(*option), option->get_description());
  return out.empty() ? out : "\n" + title + ":\n" + out;
}

/// Returns the names of options in the order of the alphabet, since CLI11 sorts options by their addresses.
std::string list_of_names(const std::string& title, const std::set<CLI::Option*>& options) {
  std::set<std::string> names;
  for (const CLI::Option* option : options) names.insert(option->get_name());
  std::string out = names.empty() ? "" : " " + title + ":";
  for (const std::string& name : names) out += " " + name;
  return out;
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const override {
    std::string out = app->get_description() + "\n" + usage(*app, name) + section(*app, "Positionals", true) +
                      section(*app, "Options", false);
    std::string commands;
    for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
      commands += entry(command->get_name(), command->get_description());
    if (!commands.empty()) out += "\nSubcommands:\n" + commands;
    const std::string footer = app->get_footer();
    return out + "\n" + (footer.empty() ? "" : footer + "\n");
  }
};

}  // namespace

void use_help_formatter(CLI::App& program) {
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_help_flag("-h,--help", "Print this help message and exit");
}

std::string option_suffix(const CLI::Option& option) {
  if (!option.get_option_text().empty()) return " " + option.get_option_text();
  std::string out;
  if (option.get_type_size() != 0) {
    if (!option.get_type_name().empty()) out += " " + option.get_type_name();
    if (!option.get_default_str().empty()) out += "=" + option.get_default_str();
    if (is_list(option)) out += " ...";
    if (option.get_required()) out += " REQUIRED";
  }
  return out + list_of_names("Needs", option.get_needs()) + list_of_names("Excludes", option.get_excludes());
}

namespace {

/// Returns the words of a rule such as "TEXT:{mean,max}", or nothing for another rule.
std::vector<std::string> words_of(const std::string& type_name) {
  const std::size_t first = type_name.find('{'), last = type_name.rfind('}');
  if (first == std::string::npos || last == std::string::npos || last < first) return {};
  std::istringstream list(type_name.substr(first + 1, last - first - 1));
  std::vector<std::string> words;
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

OptionHelp describe_option(const CLI::Option& option) {
  OptionHelp help;
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  help.text = option.get_description();
  help.words = words_of(option.get_type_name());
  help.takes_value = option.get_items_expected_max() > 0;
  help.value = option_suffix(option);
  if (!help.value.empty()) help.value.erase(0, 1);  // a space
  if (help.names.empty()) help.value = option.get_name(true);
  return help;
}

CommandHelp describe_command(const CLI::App& app) {
  CommandHelp help{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) help.options.push_back(describe_option(*option));
  return help;
}

}  // namespace

ProgramHelp describe_program(const CLI::App& app, const std::string& version) {
  ProgramHelp help{describe_command(app), {}, version};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    help.commands.push_back(describe_command(*command));
  return help;
}

void add_help_options(CLI::App& app, const std::string& version) {
  app.add_flag_callback(
      "--man", [&app, version] { throw HelpText{man_page(describe_program(app, version))}; },
      "Print the manual page, for `man -l -`");
  CLI::Option* const completion = app.add_option_function<std::string>(
      "--completion",
      [&app, version](const std::string& shell) {
        throw HelpText{completion_script(describe_program(app, version), shell)};
      },
      "Print the script with which a shell completes commands and options");
  const std::vector<std::string> shells = completion_shells();
  completion->type_name("SHELL");
  add_rule(*completion, app, one_of_words(shells), list_of_words(shells));
}

}  // namespace taxel
