// A job of a batch: one run of one scenario around one layout, with changed parameters. Plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// A changed value of a layout or a scenario.
struct JobChange {
  std::string pointer;  ///< JSON pointer below /layout or /scenario, such as /layout/material/modulus
  std::string value;    ///< JSON text
  bool operator==(const JobChange&) const = default;
};

/// One job. All random values are drawn.
struct Job {
  int line = 0;             ///< line in the list of jobs, from 1
  std::int64_t number = 0;  ///< index among the jobs of the line, from 0
  /// SHA-256 of the content: the values of layout and scenario, the bytes of the files that both name, `repeat` and
  /// `seed` of the line. Neither the place in a list nor the name of a file changes the id.
  std::string id;
  std::uint64_t seed = 0;          ///< seed of the job's random values, from the id; below 2^53
  std::string layout;              ///< absolute path of the layout file; empty for the default layout
  std::string layout_key;          ///< SHA-256 of the changed layout: jobs with the same key share a compiled sensor
  Scenario scenario;               ///< with all changes, and absolute paths
  std::vector<JobChange> changes;  ///< in the order of the line
  std::string task;                ///< task of the episode in words
  std::string error;               ///< reason why the job cannot run; empty if it can
};

/// A line of a list that gives no jobs.
struct BrokenLine {
  int line = 0;         ///< from 1
  std::string message;  ///< with a JSON pointer into the line
};

/// The jobs of a list, expanded.
struct JobList {
  std::vector<Job> jobs;             ///< in the order of the list; each id occurs once
  std::vector<BrokenLine> broken;    ///< lines without jobs
  std::vector<std::string> repeats;  ///< notes on jobs that were listed before and are left out
  std::string sha256;                ///< hash of the ids and errors in order: two lists of the same jobs have one hash
};

/// Largest number of jobs of a list.
inline constexpr std::size_t kMaxJobs = 1'000'000;

}  // namespace taxel
