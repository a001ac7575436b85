// The notes of a recording that was written earlier, from the file about the run next to it.
#pragma once

#include <filesystem>

#include "core/run/mcap/recording_mcap.h"

namespace taxel {

/// Returns the notes from the text of a file about a run: its name, its text, and the versions of the program and of
/// MuJoCo in it ("versions": {"taxel": "0.1.0", "mujoco": "4.0.1"}). Throws Error(file, JSON pointer, ...) if the text
/// is not such a file.
RunNotes parse_run_notes(const std::string& text, const std::string& name, const std::string& file);

/// Returns the notes of the run in a folder: from scenario.json or sweep.json, the newer one if there are both. They
/// are empty if there is neither. Throws Error naming the file.
RunNotes read_run_notes(const std::filesystem::path& folder);

}  // namespace taxel
