// Studies and their runs.
#include "core/document/scenario/study.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return parse_study(text, "input.json"); },
      [](const auto& value) { return study_to_json(value); });
  const auto study = read_or_refuse([&] { return parse_study(input, "input.json"); });
  if (study) require(runs_of(*study).size() <= kMostRuns, "a study has a limited number of runs");
}

const Registered kTarget("study", run);

}  // namespace
}  // namespace taxel::fuzz
