// Messages: the line above the status line, which can be copied and closed, and the list of all.
#pragma once

#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/messages/message_list.h"

namespace taxel::ui {
/// Draws the newest message that is not closed, above the bars that are at the bottom of the window already.
void draw_message_line(WindowUi& ui, PanelsShown& panels, Messages& messages);
void draw_messages_panel(WindowUi& ui, PanelsShown& panels, Messages& messages);
/// Whether a note is still to leave the line, so that another picture will be needed.
[[nodiscard]] bool toasts_will_change(const Messages& messages);
}  // namespace taxel::ui
