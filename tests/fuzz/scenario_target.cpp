// Scenarios.
#include "core/document/scenario/scenario.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return parse_scenario(text, "input.json"); },
      [](const auto& value) { return scenario_file_json(value); });
}

const Registered kTarget("scenario", run);

}  // namespace
}  // namespace taxel::fuzz
