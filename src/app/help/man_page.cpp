#include "app/help/man_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace taxel {
namespace {

/// Returns a text in which troff finds no command.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  if (out.starts_with('.') || out.starts_with('\'')) out.insert(0, "\\&");
  return out;
}

/// Returns a paragraph with the lines of a text.
std::string paragraph(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) out += (out.empty() ? ".PP\n" : ".br\n") + escaped(line) + "\n";
  return out;
}

std::string option_entry(const OptionHelp& option) {
  std::string name;
  if (option.names.empty())
    name = "\\fI" + escaped(option.value) + "\\fR";
  else
    name = "\\fB" + escaped(fmt::format("{}", fmt::join(option.names, ", "))) + "\\fR";
  if (!option.names.empty() && !option.value.empty()) name += " " + escaped(option.value);
  return ".TP\n" + name + "\n" + escaped(option.text) + "\n";
}

std::string synopsis(const std::string& program, const CommandHelp& command) {
  std::string line = ".B " + escaped(program) + "\n";
  for (const OptionHelp& option : command.options)
    if (option.names.empty()) line += ".RI [ " + escaped(option.value) + " ]\n";
  return line + ".RI [ options ]\n";
}

std::string option_list(const CommandHelp& command) {
  std::string out;
  for (const OptionHelp& option : command.options) out += option_entry(option);
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

}  // namespace

std::string man_page(const ProgramHelp& help) {
  const CommandHelp& program = help.program;
  const std::string purpose = program.text.substr(0, program.text.find('\n'));
  std::string out =
      fmt::format(".TH {} 1 \"\" \"Taxel Studio {}\" \"User commands\"\n", upper(program.name), help.version);
  out += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", program.name, escaped(purpose));
  if (help.commands.empty())
    out += synopsis(program.name, program);
  else
    out += fmt::format(".B {}\n.I command\n.RI [ options ]\n", program.name);
  out += ".SH DESCRIPTION\n" + paragraph(program.text) + paragraph(program.footer);
  out += ".SH OPTIONS\n" + option_list(program);
  if (!help.commands.empty()) out += ".SH COMMANDS\n";
  for (const CommandHelp& command : help.commands) {
    const std::string whole = program.name + " " + command.name;
    out += ".SS " + whole + "\n" + escaped(command.text) + ".\n.PP\n" + synopsis(whole, command);
    out += option_list(command) + paragraph(command.footer);
  }
  return out;
}

}  // namespace taxel
