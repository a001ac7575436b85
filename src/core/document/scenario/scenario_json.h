// A scenario as JSON: what project files, `taxel play` and the recordings' sweep.json and scenario.json hold.
#pragma once

#include <filesystem>
#include <string>

#include "core/document/scenario/scenario.h"

namespace taxel {

/// One JSON object with the values that the kind uses, SI units; shortest round-trip numbers, no newline at the end. A
/// sweep on a box names neither kind nor shape: such files are older than the shape `edge` and keep their meaning.
std::string scenario_to_json(const Scenario& scenario);

/// The same as a file of its own: {"format": "taxel-scenario", "version": 1, "scenario": {...}}.
std::string scenario_file_json(const Scenario& scenario);

/// Reads a scenario object, or a document that holds one under "scenario" (a file of its own, a sweep.json). Values
/// left out keep their defaults, which are those of a box: `shape` left out means `box`, also of a sweep. Throws
/// Error(file, JSON pointer, message) for keys that the kind does not use, wrong types, values out of range, and a
/// version of "taxel-scenario" that is not known.
Scenario parse_scenario(const std::string& text, const std::string& file = "");
/// parse_scenario of a file; paths in it stay as they are.
Scenario read_scenario(const std::filesystem::path& path);
/// The same with_absolute_files.
Scenario read_scenario_with_files(const std::filesystem::path& path);
/// The paths in it (object, source), which are relative to the file that holds it, made absolute.
Scenario with_absolute_files(Scenario scenario, const std::filesystem::path& file);

/// Throws Error("", "/key", ...) for the first value that is out of range.
void check_scenario(const Scenario& scenario);

}  // namespace taxel
