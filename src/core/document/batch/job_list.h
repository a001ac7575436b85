// A list of jobs: JSON Lines, one line for one or many jobs (docs/many_runs.md).
//
//   {"layout": "finger.taxels.json", "scenario": "press.json",
//    "set": {"/scenario/depth": {"from": 0.0005, "to": 0.002, "count": 4},
//            "/layout/material/modulus": {"values": [3e4, 5e4]},
//            "/scenario/tilt_deg": {"uniform": [10, 50]}}, "repeat": 100, "seed": 7}
//
// The line above gives 4 x 2 x 100 jobs. The last listed parameter changes faster than the ones before, and the
// repetition changes fastest.
#pragma once

#include <filesystem>
#include <string>

#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"

namespace taxel {

/// Expands the text of a list. Paths in it are relative to `folder`. A line that is not valid, or names a parameter
/// that its layout or scenario does not have, is in JobList::broken; a job with a value out of range has
/// Job::error. Throws Error naming `file` if there are more than kMaxJobs jobs.
JobList parse_job_list(const std::string& text, const std::string& file, const std::filesystem::path& folder,
                       JobSources& sources);

/// Reads a file by parse_job_list(), with paths relative to the file's folder. Throws Error if it cannot be read.
JobList read_job_list(const std::filesystem::path& path, JobSources& sources);

}  // namespace taxel
