#include "app/studio/nouns/files/file_dialog_tool.h"

#include "app/studio/nouns/files/desktop_task.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/files/file_task.h"

namespace taxel::ui {

bool uses_desktop(const FileDialog& dialog) {
  return dialog.prefers_desktop && dialog.desktop == DesktopChooser::found;
}

const char* why_no_desktop(const FileDialog& dialog) {
  switch (dialog.desktop) {
    case DesktopChooser::unused:
      return "Scripts and windows without a display use the window's own file dialog";
    case DesktopChooser::missing:
      return "No desktop file dialog found: install zenity or kdialog";
    case DesktopChooser::found:
      break;
  }
  return "";
}

void begin_own_dialog(FileDialog& dialog, FileTask task) {
  dialog.task = task;
  dialog.open = dialog.wants_focus = true;
  dialog.waits_for_desktop = false;
  dialog.path.clear();
  dialog.filter.clear();
  dialog.exists.clear();
}

void begin_dialog(FileDialog& dialog, FileTask task) {
  begin_own_dialog(dialog, task);
  dialog.waits_for_desktop = uses_desktop(dialog) && desktop_task(task);
  if (dialog.waits_for_desktop) dialog.open = dialog.wants_focus = false;
}

void open_dialog(WindowUi& ui, FileDialog& dialog) {
  begin_dialog(dialog, FileTask::open);
  ui.post(ListFolder{dialog.folder});
}

}  // namespace taxel::ui
