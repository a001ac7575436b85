// The sweep scenario as JSON: what `sweep.json` holds and `taxel sweep --scenario` reads back.
#pragma once

#include <filesystem>
#include <string>

#include "core/project/scenario.h"

namespace taxel {

/// One JSON object with every parameter, SI units; shortest round-trip numbers, no newline at the end.
std::string scenario_to_json(const SweepScenario& scenario);

/// Reads a scenario object, or a document that holds one under "scenario" (a sweep.json). Parameters left out keep
/// their defaults. Throws Error(file, JSON pointer, message) for unknown keys, wrong types and values out of range.
SweepScenario parse_scenario(const std::string& text, const std::string& file = "");
SweepScenario read_scenario(const std::filesystem::path& path);

/// Throws Error("", "/key", ...) for the first parameter that is out of range.
void check_scenario(const SweepScenario& scenario);

}  // namespace taxel
