#include "app/help/program_help.h"

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

namespace {

/// Returns a text between single quotes.
std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

/// Returns a description for zsh, in which brackets and colons have a meaning.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') out += '\\';
    out += c;
  }
  return out;
}

std::string names_of(const CommandHelp& command) {
  std::vector<std::string> names;
  for (const OptionHelp& option : command.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// Returns the branches of a case statement over "COMMAND OPTION" with the words that the options accept.
std::string bash_values(const std::string& command, const CommandHelp& help) {
  std::string out;
  for (const OptionHelp& option : help.options)
    for (const std::string& name : option.names)
      if (!option.words.empty())
        out += fmt::format("    \"{} {}\") words={} ;;\n", command, name,
                           shell_quoted(fmt::format("{}", fmt::join(option.words, " "))));
  return out;
}

std::string bash_script(const ProgramHelp& help) {
  const std::string& program = help.program.name;
  std::vector<std::string> commands;
  std::string values = bash_values("", help.program);
  std::string options = fmt::format("    \"\") words={} ;;\n", shell_quoted(names_of(help.program)));
  for (const CommandHelp& command : help.commands) {
    commands.push_back(command.name);
    values += bash_values(command.name, command);
    options += fmt::format("    {}) words={} ;;\n", command.name, shell_quoted(names_of(command)));
  }
  std::string find;
  if (!commands.empty())
    find = fmt::format(
        "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n    case \"$word\" in\n      {}) command=\"$word\"; "
        "break ;;\n    esac\n  done\n",
        fmt::join(commands, "|"));
  return fmt::format(
      "# Completion of {0} in bash, written by `{0} --completion bash`.\n"
      "_{0}() {{\n"
      "  local current=\"${{COMP_WORDS[COMP_CWORD]}}\" previous=\"${{COMP_WORDS[COMP_CWORD-1]}}\" command=\"\" "
      "words=\"\" "
      "word\n{1}"
      "  case \"$command $previous\" in\n{2}    *) words=\"\" ;;\n  esac\n"
      "  [[ -n \"$words\" || \"$current\" != -* ]] || case \"$command\" in\n{3}  esac\n"
      "  [[ -n \"$words\" || -n \"$command\" || \"$previous\" == -* ]] || words={4}\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "}}\n"
      "complete -o default -F _{0} {0}\n",
      program, find, values, options, shell_quoted(fmt::format("{}", fmt::join(commands, " "))));
}

std::string fish_option(const std::string& program, const std::string& condition, const OptionHelp& option) {
  std::string line = fmt::format("complete -c {}", program);
  if (!condition.empty()) line += fmt::format(" -n {}", shell_quoted(condition));
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.words.empty())
    line += fmt::format(" -x -a {}", shell_quoted(fmt::format("{}", fmt::join(option.words, " "))));
  else if (option.takes_value)
    line += " -r";
  return line + " -d " + shell_quoted(option.text) + "\n";
}

std::string fish_script(const ProgramHelp& help) {
  const std::string& program = help.program.name;
  std::string out = fmt::format("# Completion of {0} in fish, written by `{0} --completion fish`.\n", program);
  const std::string at_first = help.commands.empty() ? "" : "__fish_use_subcommand";
  for (const OptionHelp& option : help.program.options)
    if (!option.names.empty()) out += fish_option(program, at_first, option);
  for (const CommandHelp& command : help.commands) {
    out += fmt::format("complete -c {} -n {} -f -a {} -d {}\n", program, at_first, command.name,
                       shell_quoted(command.text));
    for (const OptionHelp& option : command.options)
      if (!option.names.empty()) out += fish_option(program, "__fish_seen_subcommand_from " + command.name, option);
  }
  return out;
}

/// Returns a call of zsh's _arguments for the options of a command.
std::string zsh_arguments(const CommandHelp& command, const std::string& indent) {
  std::string out = indent + "_arguments";
  for (const OptionHelp& option : command.options)
    for (const std::string& name : option.names) {
      std::string spec = fmt::format("*{}[{}]", name, zsh_text(option.text));
      if (!option.words.empty())
        spec += fmt::format(":value:({})", fmt::join(option.words, " "));
      else if (option.takes_value)
        spec += ":value:_files";
      out += " \\\n" + indent + "  " + shell_quoted(spec);
    }
  return out + " \\\n" + indent + "  '*:file:_files'\n";
}

std::string zsh_script(const ProgramHelp& help) {
  const std::string& program = help.program.name;
  std::string body = zsh_arguments(help.program, "  ");
  if (!help.commands.empty()) {
    body = "  local -a commands=(\n";
    for (const CommandHelp& command : help.commands)
      body += fmt::format("    {}\n", shell_quoted(command.name + ":" + command.text));
    body +=
        "  )\n  if (( CURRENT == 2 )) && [[ \"$words[2]\" != -* ]]; then\n    _describe command commands\n    return\n "
        " fi\n";
    body += "  local command=\"$words[2]\"\n  case \"$command\" in\n";
    for (const CommandHelp& command : help.commands)
      body += fmt::format("    {})\n      shift words; (( CURRENT-- ))\n{}      ;;\n", command.name,
                          zsh_arguments(command, "      "));
    body += "    *)\n" + zsh_arguments(help.program, "      ") + "      ;;\n  esac\n";
  }
  return fmt::format(
      "#compdef {0}\n# Completion of {0} in zsh, written by `{0} --completion zsh`.\n_{0}() {{\n{1}}}\n"
      "if [ \"$funcstack[1]\" = _{0} ]; then _{0} \"$@\"; else compdef _{0} {0}; fi\n",
      program, body);
}

}  // namespace

std::vector<std::string> completion_shells() {
  return {"bash", "fish", "zsh"};
}

std::string completion_script(const ProgramHelp& help, const std::string& shell) {
  if (shell == "fish") return fish_script(help);
  return shell == "zsh" ? zsh_script(help) : bash_script(help);
}

}  // namespace taxel
