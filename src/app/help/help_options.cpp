#include "app/help/help_options.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>

#include "app/help/completion.h"
#include "app/help/help_formatter.h"
#include "app/help/man_page.h"
#include "app/help/option_values.h"

namespace taxel {
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
