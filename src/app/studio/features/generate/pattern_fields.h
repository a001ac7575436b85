// The parameters of a pattern as fields with units. Each kind of pattern has its own fields.
#pragma once

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/generate/generate_state.h"

namespace taxel::ui {
void draw_pattern_fields(WindowUi& ui, const DocumentView& document, GenerateState& generate, FileDialog& dialog);
}  // namespace taxel::ui
