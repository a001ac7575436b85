// What is said about open files that were changed or deleted by somebody else.
#pragma once

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/files_state.h"

namespace taxel::ui {
/// At the top of the view: one card each, with what can be done.
void draw_file_notices(WindowUi& ui, const ViewPlace& place, const std::vector<FileNotice>& notices);
}  // namespace taxel::ui
