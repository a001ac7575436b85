// Exports of the document and of the run.
#pragma once

#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "ui/gl/rgb_image.h"

namespace taxel::ui {

struct ExportFile {
  FileTask task = FileTask::export_layout;
  std::string path = {};  ///< empty if the file is to be asked for
  bool replace = false;
  int width = 0, height = 0;  ///< size of an image [pixels]
  bool operator==(const ExportFile&) const = default;
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ExportFile& command, Host& host);

/// Writes the export that was requested while samples were polished. Drops the export if the document is closed or
/// cannot be compiled.
void export_when_ready(Host& host);
/// Draws the scene as the view shows it; lines and points grow with the image.
[[nodiscard]] gl::RgbaImage cut_out(Host& host, int width, int height);

}  // namespace taxel::studio
