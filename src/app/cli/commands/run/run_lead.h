// Options of `taxel run` for the start state and for files that lead the scene.
#pragma once

#include <string>

#include "app/cli/command_line.h"
#include "core/run/lead/read_lead.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

/// Adds --keyframe, --ctrl, --mocap and --replay.
void add_lead(OptionList& list, LeadRequest& request);

/// Loads the keyframe and leads the scene of the file `scene`. Prints notes and warnings about the files. Returns the
/// length of a run up to the last row of the files [s]; 0 if no file leads. Throws Error for bad input.
double lead_scene(Simulator& simulator, const LeadRequest& request, const std::string& scene, Console& console);

}  // namespace taxel::cli
