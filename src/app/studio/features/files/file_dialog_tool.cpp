#include "app/studio/features/files/file_dialog_tool.h"

namespace taxel::ui {

void begin_dialog(FileDialog& dialog, FileTask task) {
  dialog.task = task;
  dialog.open = dialog.wants_focus = true;
  dialog.path.clear();
  dialog.filter.clear();
  dialog.exists.clear();
}

void open_dialog(WindowUi& ui, FileDialog& dialog) {
  begin_dialog(dialog, FileTask::open);
  ui.post(ListFolder{dialog.folder});
}

}  // namespace taxel::ui
