#include "core/document/scenario/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/document/scenario/scenario.h"

namespace taxel {
namespace {

constexpr double kLargestSeed = 9007199254740992;  // 2^53: whole numbers up to here are exact

void set(StudyRun& run, const std::string& key, double value) {
  run.values.push_back(value);
  if (key == "density") {
    run.density = value;
  } else if (key == "seed") {
    run.seed = static_cast<std::uint64_t>(value);
  } else {
    *find_number(run.scenario, key) = value;
  }
}

void check_value(const Study& study, const std::string& key, double value, const std::string& at) {
  if (key == "seed") {
    if (!(value >= 0 && value <= kLargestSeed && value == std::floor(value)))
      throw Error("", at, fmt::format("must be a whole number from 0, is {}", value));
  } else if (key == "density") {
    if (!(value > 0) || !std::isfinite(value)) throw Error("", at, fmt::format("must be greater than 0, is {}", value));
  } else {
    Scenario scenario = study.scenario;
    *find_number(scenario, key) = value;
    try {
      check_scenario(scenario);
    } catch (const Error& e) {
      throw Error("", at, e.message());
    }
  }
}

}  // namespace

std::vector<StudyRun> runs_of(const Study& study) {
  std::vector<StudyRun> runs{{study.scenario, {}, {}, {}}};
  for (const StudyParameter& parameter : study.parameters) {
    std::vector<StudyRun> more;
    for (const StudyRun& run : runs) {
      for (const double value : parameter.values) {
        more.push_back(run);
        set(more.back(), parameter.key, value);
      }
    }
    runs = std::move(more);
  }
  return runs;
}

void check_study(const Study& study) {
  try {
    check_scenario(study.scenario);
  } catch (const Error& e) {
    throw Error("", "/scenario" + e.where(), e.message());
  }
  if (study.parameters.empty() || study.parameters.size() > 2)
    throw Error("", "/parameters", fmt::format("must be one or two, are {}", study.parameters.size()));
  std::size_t runs = 1;
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const StudyParameter& parameter = study.parameters[i];
    const std::string at = fmt::format("/parameters/{}", i);
    const bool layout = parameter.key == "density" || parameter.key == "seed";
    if (!layout && find_number(study.scenario, parameter.key) == nullptr)
      throw Error("", at + "/parameter",
                  fmt::format("\"{}\" is neither density nor seed, nor a number of the kind \"{}\"", parameter.key,
                              to_word(study.scenario.kind())));
    if (i > 0 && parameter.key == study.parameters[0].key)
      throw Error("", at + "/parameter", fmt::format("\"{}\" is varied already", parameter.key));
    if (parameter.values.empty()) throw Error("", at + "/values", "must be at least one");
    for (std::size_t k = 0; k < parameter.values.size(); ++k)
      check_value(study, parameter.key, parameter.values[k], fmt::format("{}/values/{}", at, k));
    runs *= std::min(parameter.values.size(), kMostRuns + 1);
  }
  if (runs > kMostRuns) throw Error("", "/parameters", fmt::format("make more than {} runs", kMostRuns));
}

}  // namespace taxel
