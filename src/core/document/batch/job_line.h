// One line of a list of jobs, as read: the parameters with their values, before the expansion.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/document/batch/draws.h"

namespace taxel {

/// A parameter of a line.
struct JobParameter {
  std::string pointer;                                  ///< below /layout or /scenario
  std::variant<std::vector<std::string>, Draw> values;  ///< JSON texts of the values, or a distribution
};

struct JobLine {
  std::string layout;         ///< absolute path; empty for the default layout
  std::string scenario;       ///< JSON text of the scenario
  std::string scenario_file;  ///< file in whose folder the paths of the scenario begin
  std::vector<JobParameter> parameters;
  std::int64_t repeat = 1;
  std::uint64_t seed = 0;
  std::string task;  ///< empty if the line names none

  /// Returns the number of jobs, at most kMaxJobs + 1.
  [[nodiscard]] std::size_t count() const;
};

/// Parses a line. Throws Error("", JSON pointer, ...) if it is not valid.
JobLine parse_job_line(const std::string& text, const std::filesystem::path& folder);

}  // namespace taxel
