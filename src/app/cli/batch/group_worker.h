// A worker: a process that keeps compiled layouts, and runs groups of jobs that it reads from stdin.
#pragma once

#include <string>

#include "app/cli/batch/batch_events.h"

namespace taxel::cli {

/// Runs each line of stdin, a package of jobs (core/sim/batch/job_package.h) in which `files` names a copy of each
/// file, and answers with the bytes of the shard. Returns the exit status at the end of stdin. Throws Error for a line
/// that is not a package, and for a copy that is missing.
int run_groups_of_stdin(const std::string& program, BatchEvents& events);

}  // namespace taxel::cli
