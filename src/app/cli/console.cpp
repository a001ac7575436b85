#include "app/cli/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "core/base/error.h"
#include "core/base/os/process.h"
#include "core/base/text/message.h"

namespace taxel::cli {
namespace {

/// A bar with a text is shorter, so that both fit into a row of 80 columns, without which a line could not be cleared.
constexpr std::size_t kBarWidth = 40, kBarWidthWithText = 20, kTextWidth = 48;

/// Returns a message on one line, because scripts read messages line by line.
std::string one_line(const std::string& message) {
  std::string text = shown_part(message, kMostShownLine);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// Prints to stderr. Does nothing if nobody can read it: a message must not end a run, nor the handler of a signal.
void print_error(const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
  static_cast<void>(std::fflush(stderr));
}

}  // namespace

Console::Console(const CommonOptions& options) : options_(options), terminal_(os::is_terminal_stderr()) {}

void Console::result(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw Error("stdout", "cannot be written");
  }
}

/// Removes the bar, so that a message begins on an empty line. The next progress() shows the bar again.
void Console::clear_bar() {
  if (shown_percent_ >= 0) print_error(fmt::format("\r{:{}}\r", "", shown_width_));
  shown_percent_ = -1;
  shown_width_ = 0;
}

void Console::print_message(std::string_view kind, const std::string& message) {
  if (options_.quiet) return;
  clear_bar();
  print_error(fmt::format("taxel: {}: {}\n", kind, one_line(message)));
}
void Console::note(const std::string& message) {
  print_message("note", message);
}
void Console::warn(const std::string& message) {
  print_message("warning", message);
}

void Console::report(const Problems& problems) {
  for (const Problem& problem : problems) {
    const std::string line = problem.file + ": " + shown_part(problem.pointer) + ": " + shown_part(problem.message);
    problem.severity == Severity::note ? note(line) : warn(line);
  }
}

void Console::progress(double fraction, const std::string& text) {
  if (!terminal_ || options_.quiet) return;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  if (percent >= 100) return clear_bar();
  if (percent == shown_percent_ && text == shown_text_) return;
  shown_percent_ = percent;
  shown_text_ = text;
  const std::size_t width = text.empty() ? kBarWidth : kBarWidthWithText,
                    filled = width * static_cast<std::size_t>(percent) / 100;
  std::string line = fmt::format("[{}{}] {:3d} %", std::string(filled, '#'), std::string(width - filled, '.'), percent);
  if (!text.empty()) line += "  " + text.substr(0, kTextWidth);
  shown_width_ = std::max(shown_width_, line.size());
  print_error(fmt::format("\r{:{}}", line, shown_width_));  // blanks remove the rest of a longer line
}

void print_failure(const std::string& message) {
  print_error(fmt::format("taxel: {}\n", one_line(message)));
}
void print_failure(const Error& error) {
  print_failure(shown_message(error));
}

}  // namespace taxel::cli
