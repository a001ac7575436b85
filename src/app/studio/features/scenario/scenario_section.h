// The inspector's part about how the finger is led.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/scenario/path_state.h"

namespace taxel::ui {

/// Kind, its values, its way points, and the button that runs it. Each change is an edit of the document.
void draw_scenario_section(WindowUi& ui, const Viewer& viewer, const Shown& displayed, PathState& path,
                           Messages& messages);

}  // namespace taxel::ui
