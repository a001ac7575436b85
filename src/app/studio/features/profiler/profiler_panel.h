// The profiler: the time of simulation steps and of frames, split into parts.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/profiler/profile_state.h"

namespace taxel::ui {
void draw_profiler_panel(WindowUi& ui, const RunView& run, bool& open, const ProfileState& profile);
}  // namespace taxel::ui
