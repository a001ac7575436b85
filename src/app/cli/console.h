// Output of a command: results on stdout, messages and progress on stderr.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace taxel::cli {

/// The options that every command has.
struct CommonOptions {
  bool json = false;   ///< prints the result as one JSON object
  bool quiet = false;  ///< prints errors only, no messages and no progress
  int threads = 0;     ///< largest number of threads, or 0 for all cores
};

/// Prints the output of one command, as its common options ask for.
class Console {
 public:
  explicit Console(const CommonOptions& options);

  [[nodiscard]] bool json() const { return options_.json; }
  /// Prints text to stdout without changes. Throws Error if stdout cannot be written.
  void result(std::string_view text);
  /// Print one line to stderr, unless --quiet was given.
  void note(const std::string& message);
  void warn(const std::string& message);
  /// Prints problems that do not stop the command, as notes and warnings.
  void report(const Problems& problems);
  /// Shows the progress of a long computation, in [0, 1], as a bar if stderr is a terminal. 1 removes the bar.
  void progress(double fraction) { progress(fraction, ""); }
  /// Shows a text behind the bar, of at most 50 characters.
  void progress(double fraction, const std::string& text);

 private:
  void print_message(std::string_view kind, const std::string& message);
  void clear_bar();

  CommonOptions options_;
  bool terminal_ = false;
  int shown_percent_ = -1;       ///< percentage of the visible bar, or -1 without a bar
  std::string shown_text_;       ///< text behind the visible bar
  std::size_t shown_width_ = 0;  ///< columns that the bar and its text have used
};

/// Prints the line that ends a failed run, "taxel: ...", to stderr.
void print_failure(const std::string& message);
void print_failure(const Error& error);

}  // namespace taxel::cli
