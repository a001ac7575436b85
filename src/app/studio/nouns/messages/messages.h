// Messages: the line above the status line, which can be copied and closed, and the list of all.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {
/// Whether a note is still to leave the line, so that another picture will be needed.
[[nodiscard]] bool toasts_will_change(const Messages& messages);

/// All messages.
extern const Feature kMessages;

/// The newest message that is not closed, above the bars that are at the bottom of the window already.
extern const Feature kMessageLine;
/// Sets "messages".
void dump_messages(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
