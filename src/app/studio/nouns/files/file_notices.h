// Notices about open files that another program changed or deleted.
#pragma once

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/files_state.h"

namespace taxel::ui {
/// Draws one popup per notice at the top of the view, with the possible remedies.
void draw_file_notices(WindowUi& ui, const ViewPlace& place, const std::vector<FileNotice>& notices);
}  // namespace taxel::ui
