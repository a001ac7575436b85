#include "app/cli/console.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "core/base/error.h"

namespace taxel::cli {
namespace {

/// No line breaks: scripts read one line.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

Console::Console(const CommonOptions& options)
    : options_(options),
      log_("taxel", std::make_shared<spdlog::sinks::stderr_sink_st>()),
      terminal_(::isatty(STDERR_FILENO) == 1) {
  log_.set_pattern("taxel: %v");
  log_.set_level(options.quiet ? spdlog::level::off : spdlog::level::info);
}

void Console::result(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw Error("stdout", "cannot be written");
  }
}

/// A message begins on an empty line; the bar comes back with the next progress.
void Console::clear_bar() {
  if (shown_percent_ >= 0) std::fputs(fmt::format("\r{:50}\r", "").c_str(), stderr);
  shown_percent_ = -1;
}

void Console::note(const std::string& message) {
  clear_bar();
  log_.info("note: {}", one_line(message));
}
void Console::warn(const std::string& message) {
  clear_bar();
  log_.warn("warning: {}", one_line(message));
}

void Console::tell(const Problems& problems) {
  for (const Problem& problem : problems) {
    const std::string line = problem.file + ": " + problem.pointer + ": " + problem.message;
    problem.severity == Severity::note ? note(line) : warn(line);
  }
}

void Console::progress(double fraction) {
  if (!terminal_ || options_.quiet) return;
  constexpr int kWidth = 40;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  if (percent >= 100) return clear_bar();
  if (percent == shown_percent_) return;
  shown_percent_ = percent;
  const int filled = kWidth * percent / 100;
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(kWidth - filled), '.');
  std::fputs(fmt::format("\r[{}] {:3d} %", bar, percent).c_str(), stderr);
  std::fflush(stderr);
}

void print_failure(const std::string& message) {
  std::fputs(fmt::format("taxel: {}\n", one_line(message)).c_str(), stderr);
}

}  // namespace taxel::cli
