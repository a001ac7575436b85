// A reader under test. A fuzzer calls it with bytes of its own, the ordinary tests with seeds and with inputs that once
// failed. Each file *_target.cpp of this folder registers one.
#pragma once

#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace taxel::fuzz {

/// A target of this name. `run` reads `input` as a file of the reader's format, and checks what was read: that it can
/// be written and read again, or that its numbers are within their limits. It throws nothing for input that is refused
/// with an Error. Everything else that it throws, a crash, a hang and a leak are findings.
struct Target {
  std::string name;
  void (*run)(const std::string& input);
};

/// Prints a target in the messages of tests.
inline void PrintTo(const Target& target, std::ostream* out) {
  *out << target.name;
}

/// All targets of this program, in the order in which their files were linked.
inline std::vector<Target>& targets() {
  static std::vector<Target> all;
  return all;
}

/// Adds a target while the program starts.
struct Registered {
  Registered(const char* name, void (*run)(const std::string& input)) { targets().push_back({name, run}); }
};

/// Throws std::logic_error if a rule is broken: a finding.
inline void require(bool holds, const std::string& rule) {
  if (!holds) throw std::logic_error("broken rule: " + rule);
}

/// Returns what `read` returns, or nothing if it refuses by Error or Cancelled. An Error must say why.
template <class Read>
auto read_or_refuse(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Error& error) {
    require(!error.message().empty(), "an error has a message");
  } catch (const Cancelled&) {
  }
  return std::nullopt;
}

/// Reads `text` by `parse`. The value must be one that `write` writes, and the written text must read back and be
/// written the same way.
template <class Parse, class Write>
void read_and_write_again(const std::string& text, const Parse& parse, const Write& write) {
  const auto value = read_or_refuse([&] { return parse(text); });
  if (!value) return;
  const std::string written = write(*value);
  require(write(parse(written)) == written, "a value that is read can be written and read again");
}

}  // namespace taxel::fuzz
