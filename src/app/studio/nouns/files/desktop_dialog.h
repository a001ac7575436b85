// The desktop's own file dialog in place of the window's: one at a time, while the window is drawn. And the command
// by which both dialogs answer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "core/base/os/file_chooser.h"

namespace taxel::ui {

/// Returns the command of the dialog's task for a path. A name without an extension gets the extension of the task, but
/// a layout keeps every extension that names a format of layouts, and a plot keeps ".pdf". The command replaces an
/// existing file only if the dialog has asked about that file. `geoms` are the geoms that a layout is attached to.
[[nodiscard]] Command file_command(const FileDialog& dialog, const std::vector<std::string>& geoms,
                                   const std::string& path);

/// The parts of the window that the desktop's dialog changes.
struct DesktopDialogStage {
  WindowUi& ui;
  FileDialog& dialog;
  Messages& messages;
  const std::vector<FileNotice>& notices;  ///< files that other programs have changed
  double now = 0;                          ///< interface time [s]
};

class DesktopDialog {
 public:
  explicit DesktopDialog(std::unique_ptr<os::FileChooser> chooser) : chooser_(std::move(chooser)) {}

  [[nodiscard]] bool is_open() const { return asked_.has_value(); }

  /// Opens the desktop's dialog if the window's waits for it, and posts the command of a reply: that of the window's
  /// dialog for a chosen file, DialogClosed after Cancel. After an error the window's dialog asks. A request while the
  /// dialog is open is refused with a message. `geoms` are the geoms that a layout is attached to. Returns whether the
  /// window has to be drawn. Does not wait for the user.
  bool update(const DesktopDialogStage& stage, const std::vector<std::string>& geoms);

  /// Closes the dialog, unless it asks for a file to open: the file that it names would be that of another document.
  void leave_document();

 private:
  void open(FileDialog& dialog, const std::vector<std::string>& geoms);
  void refuse(const DesktopDialogStage& stage) const;
  void finish(const DesktopDialogStage& stage, const os::FileReply& reply);

  std::unique_ptr<os::FileChooser> chooser_;
  std::optional<FileDialog> asked_;  ///< task, folder and proposed name of the open dialog
  std::vector<std::string> geoms_;
};

}  // namespace taxel::ui
