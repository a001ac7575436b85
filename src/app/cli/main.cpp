// taxel: Taxel Studio without a window.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <exception>
#include <optional>

#include "app/cli/command_line.h"
#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/base/os/process.h"
#include "core/sensor/stored_samples.h"

namespace {

using namespace taxel::cli;

/// Runs the chosen command. Returns its exit status; throws Error for bad usage or bad input.
int run(int argc, char** argv) {
  const ParsedCommandLine parsed = parse_command_line(argc, argv);
  std::optional<tbb::global_control> limit;
  if (parsed.common.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(parsed.common.threads));
  taxel::keep_samples_on_disk();
  Console console(parsed.common);
  return parsed.run(console);
}

}  // namespace

int main(int argc, char** argv) {
  taxel::os::prepare_process();
  handle_signals();
  try {
    return run(argc, argv);
  } catch (const taxel::Error& e) {
    print_failure(e);
  } catch (const std::bad_alloc&) {
    print_failure("out of memory");
  } catch (const std::exception& e) {
    print_failure(fmt::format("unexpected: {}", e.what()));
  } catch (...) {
    print_failure("unexpected failure");
  }
  return kBadInput;
}
