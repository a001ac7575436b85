// What is said about open files that were changed or deleted by somebody else.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {
/// At the top of the view: one card each, with what can be done.
void draw_file_notices(UiState& ui);
}  // namespace taxel::ui
