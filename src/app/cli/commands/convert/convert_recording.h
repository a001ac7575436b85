// The part of taxel convert that writes recorded runs in other formats.
#pragma once

#include <string>

#include "app/cli/console.h"

namespace taxel::cli {

/// Returns true if a file is a recording by its name: *.mcap, or *.jsonl for the messages of tactile_msgs/TactileState.
bool is_recording_output(const std::string& out);

/// Returns true if a file is the unfinished.rows of a run that has ended early.
bool is_unfinished_run(const std::string& in);

/// Writes the rows of such a run as write_recording() does, and leaves them where they are. Prints a report. Throws
/// Error naming the file.
void convert_unfinished_run(const std::string& in, const std::string& out, Console& console);

/// Reads a run (a folder, or its readings.npz) and writes `out`: the same bytes as `taxel sweep --mcap` and
/// `--tactile-state` write next to it. Prints a report. Throws Error naming the file.
void convert_recording(const std::string& in, const std::string& out, Console& console);

}  // namespace taxel::cli
