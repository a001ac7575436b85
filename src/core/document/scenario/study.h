// A parameter study: one scenario, run with several values of one or two parameters.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// What is varied: a number of the scenario by its key, or `density` [1/m^2] or `seed` of the layout's samples.
struct StudyParameter {
  std::string key;
  std::vector<double> values;  ///< SI, in the order of the runs
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
  std::vector<double> values;  ///< of the parameters, in their order
};

/// Runs of a study are limited to what a machine can hold and a hand can look at.
inline constexpr std::size_t kMostRuns = 1000;

/// All of them; the second parameter changes fastest.
std::vector<StudyRun> runs_of(const Study& study);

/// Throws Error("", pointer, ...) for the first value that cannot be: a parameter that the scenario's kind does not
/// use, twice the same, none or too many values, one that is out of range.
void check_study(const Study& study);

/// {"format": "taxel-study", "version": 1, "scenario": {...}, "parameters": [{"parameter": "depth", "values": [...]}]};
/// instead of values, "from", "to" and "count" give that many at even distances. Throws Error(file, JSON pointer, ...).
Study parse_study(const std::string& text, const std::string& file = "");
/// parse_study of a file; paths in its scenario, which are relative to the file, made absolute.
Study read_study(const std::filesystem::path& path);
std::string study_to_json(const Study& study);

}  // namespace taxel
