// The rows a second of the jobs of a list. A data set has one rate, and even intervals.
#pragma once

#include <string>

#include "core/document/batch/job.h"

namespace taxel {

/// Throws Error naming `file`, the rates and a line of each unless all jobs without an error have the same rate and a
/// whole number of time steps between two rows.
void check_rates(const JobList& list, const std::string& file);

}  // namespace taxel
