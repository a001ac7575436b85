// A small file dialog with a list, a path and a filter. The program lists the folders.
#pragma once

#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/files/file_command.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "app/studio/features/video/video_state.h"

namespace taxel::ui {
void draw_file_dialog(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog);
}  // namespace taxel::ui
