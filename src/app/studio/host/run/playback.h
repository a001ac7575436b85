// Play, pause and speed of a run.
#pragma once

#include "core/run/event.h"

namespace taxel::studio {

/// The requested state, which the simulation may not have reached yet.
struct Playback {
  bool plays = false;     ///< the simulation plays, or will when it executes `command`
  bool is_held = false;   ///< the run and its single steps wait for polished samples
  int held_steps = 0;     ///< number of single steps that wait
  double speed = 1;       ///< multiples of real time
  CommandId command = 0;  ///< the latest command that plays or pauses
};

}  // namespace taxel::studio
