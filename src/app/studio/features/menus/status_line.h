// The line at the bottom: rates, force, counts, messages.
#pragma once

#include <string>

#include "app/studio/app/values/arrangement.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/messages/message_list.h"

namespace taxel::ui {
void draw_status_line(WindowUi& ui, const Viewer& viewer, const Shown& shown, Arrangement& arrangement,
                      const Messages& messages);

/// "0.98 x real time", or that the simulation is "paused" or has "ended"; empty where there is none, or no clock.
std::string pace_text(const Shown& shown);
}  // namespace taxel::ui
