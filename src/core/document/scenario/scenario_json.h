// Reads and writes scenarios as JSON: in project files, scenario files, and the sweep.json of recordings.
#pragma once

#include <filesystem>
#include <string>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// Returns one JSON object with the values that the scenario uses, in SI units, with shortest round-trip numbers and no
/// newline at the end. A sweep on a box names neither kind nor shape, because older files do not have these keys.
std::string scenario_to_json(const Scenario& scenario);

/// Returns the text of a scenario file: {"format": "taxel-scenario", "version": 1, "scenario": {...}}.
std::string scenario_file_json(const Scenario& scenario);

/// Reads a scenario object, or a document with a scenario under "scenario" (a scenario file, a sweep.json). Missing
/// values have the defaults of a box: without `shape`, the object is a box, also in a sweep. Throws
/// Error(file, JSON pointer, message) for keys that the kind does not use, wrong types, values out of range, and an
/// unknown version of "taxel-scenario".
Scenario parse_scenario(const std::string& text, const std::string& file = "");
/// Reads a file by parse_scenario, without changing its paths.
Scenario read_scenario(const std::filesystem::path& path);
/// Reads a file by parse_scenario and makes its paths absolute.
Scenario read_scenario_with_files(const std::filesystem::path& path);
/// Returns the scenario with absolute paths (object, source). Its paths are relative to the folder of `file`.
Scenario with_absolute_files(Scenario scenario, const std::filesystem::path& file);

/// Throws Error("", "/key", ...) for the first value that is not valid.
void check_scenario(const Scenario& scenario);

}  // namespace taxel
