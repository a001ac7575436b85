// The parameters of a pattern as fields with units. Each kind of pattern has its own fields.
#pragma once

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"

namespace taxel::ui {
void draw_pattern_fields(WindowUi& ui, const DocumentView& document, GenerateState& generate, FileDialog& dialog);
}  // namespace taxel::ui
