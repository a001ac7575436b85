#include "app/cli/batch/group_worker.h"

#include "app/cli/command_line.h"
#include "app/cli/default_layout.h"
#include "core/base/os/standard_input.h"
#include "core/sim/batch/job_package.h"

namespace taxel::cli {

int run_groups_of_stdin(const std::string& program, BatchEvents& events) {
  using Result = os::StandardInput::Result;
  JobSources sources([] { return default_source(); });
  JobRunner runner(sources);
  JobWatch watch;
  watch.on_end = [&](const Job&, const std::string&) { events.job_ended(); };
  events.program(program);
  os::StandardInput input;
  std::string line;
  for (Result result = input.take_line(line); result != Result::ended; result = input.take_line(line)) {
    if (result == Result::waiting) continue;
    const JobPackage package = parse_package(line);
    events.shard(package.group, run_package(package, sources, runner, watch));
  }
  return kDone;
}

}  // namespace taxel::cli
