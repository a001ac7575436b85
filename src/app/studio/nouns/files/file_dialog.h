// A small file dialog with a list, a path and a filter. The program lists the folders.
#pragma once

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_command.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/video/video_state.h"

namespace taxel::ui {
void draw_file_dialog(WindowUi& ui, const ControlsState& controls, VideoState& video, FileDialog& dialog);
}  // namespace taxel::ui
