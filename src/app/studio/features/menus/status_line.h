// The status line at the bottom of the window: rates, force, counts, messages.
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

/// Returns "0.98 x real time", or a word for a run that is paused, has ended or waits for polished samples. Empty
/// without a scene, and while a run plays in script mode.
std::string pace_text(const Shown& shown);
}  // namespace taxel::ui
