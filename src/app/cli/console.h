// Where a command speaks: results on stdout, messages and progress on stderr.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace taxel::cli {

/// Options that every command has.
struct CommonOptions {
  bool json = false;   ///< the result on stdout as one JSON object
  bool quiet = false;  ///< no messages and no progress on stderr, errors excepted
  int threads = 0;     ///< 0: all cores
};

class Console {
 public:
  explicit Console(const CommonOptions& options);

  [[nodiscard]] bool json() const { return options_.json; }
  /// Text for stdout, as it is. Throws Error when stdout does not take it.
  void result(std::string_view text);
  /// A line for stderr; --quiet drops it.
  void note(const std::string& message);
  void warn(const std::string& message);
  /// Notes and warnings that are not worth stopping for.
  void tell(const Problems& problems);
  /// How far a long work is, in [0, 1]: a bar, only on a terminal. 1 clears it.
  void progress(double fraction);

 private:
  void say(std::string_view kind, const std::string& message);
  void clear_bar();

  CommonOptions options_;
  bool terminal_ = false;
  int shown_percent_ = -1;  ///< of the bar that stands on the terminal; -1: none
};

/// The one line that ends a failed run: "taxel: ..." on stderr.
void print_failure(const std::string& message);

}  // namespace taxel::cli
