// A parameter study: one scenario, run with several values of one or two parameters.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/layout/layout.h"

namespace taxel {

/// A varied number: a number of the scenario by its key, or `density` [1/m^2] or `seed` of the layout's samples.
struct StudyParameter {
  std::string key;
  std::vector<double> values;  ///< SI values in the order of the runs
  bool operator==(const StudyParameter&) const = default;
};

struct Study {
  Scenario scenario;
  std::vector<StudyParameter> parameters;  ///< one or two
  bool operator==(const Study&) const = default;
};

struct StudyRun {
  Scenario scenario;
  std::optional<double> density;
  std::optional<std::uint64_t> seed;
  std::vector<double> values;  ///< values of the parameters, in their order
};

/// Largest number of runs: more do not fit into memory, and a user cannot compare them.
inline constexpr std::size_t kMostRuns = 1000;

/// Returns the runs of a study. The second parameter changes fastest.
std::vector<StudyRun> runs_of(const Study& study);

/// Throws Error("", pointer, ...) for the first error: a parameter that the scenario does not use or that is listed
/// twice, no value, too many runs, or a value out of range.
void check_study(const Study& study);

/// Parses {"format": "taxel-study", "version": 1, "scenario": {...}, "parameters": [{"parameter": "depth", "values":
/// [...]}]}. In place of "values", "from", "to" and "count" give values at even distances. Throws Error(file, JSON
/// pointer, ...).
Study parse_study(const std::string& text, const std::string& file = "");
/// Reads a file by parse_study and makes the paths of its scenario absolute. They are relative to the file's folder.
Study read_study(const std::filesystem::path& path);
std::string study_to_json(const Study& study);

// The readings of all runs of a study.

struct StudyCurve {
  StudyRun run;
  std::vector<double> time;                   ///< time of each row [s]
  std::vector<std::vector<double>> readings;  ///< readings by taxel and row, SI
  std::string error;                          ///< error of the run, or empty
};

struct StudyCurves {
  Study study;
  Aggregate aggregate = Aggregate::mean;  ///< aggregate of the readings, which has their unit
  std::string folder;                     ///< batch that the runs were read from, or empty
  std::vector<int> taxel_ids;             ///< ids in the order of the readings
  std::vector<StudyCurve> runs;
  double largest_reading = 0, longest = 0;  ///< largest reading and largest time [s] of all runs
  std::string problem;                      ///< reason why there are no runs, or empty
};
using StudyCurvesPtr = std::shared_ptr<const StudyCurves>;

}  // namespace taxel
