// A small file dialog of our own: a list, a path, a filter. Folders are listed by the program.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_command.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "app/studio/features/video/video_state.h"

namespace taxel::ui {
void draw_file_dialog(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog);
}  // namespace taxel::ui
