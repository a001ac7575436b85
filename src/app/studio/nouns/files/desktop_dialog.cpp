#include "app/studio/nouns/files/desktop_dialog.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/layout/formats/layout_format.h"

namespace taxel::ui {
namespace {

bool names_format(const std::string& path) {
  const LayoutFormat* format = layout_format_of(path);
  return format != nullptr && format->write != nullptr;
}

}  // namespace

Command file_command(const FileDialog& dialog, const std::vector<std::string>& geoms, const std::string& path) {
  if (dialog.task == FileTask::open) return OpenFile{path};
  if (dialog.task == FileTask::import_recording) return ReadRealRecording{path};
  if (dialog.task == FileTask::read_points) return ReadPoints{path};
  if (dialog.task == FileTask::attach_layout) return AttachLayout{geoms, path};
  if (dialog.task == FileTask::compare_layout) return CompareLayout{path};
  if (dialog.task == FileTask::save_study) return SaveStudy{path};
  if (dialog.task == FileTask::open_study) return OpenStudy{path};
  if (dialog.task == FileTask::save_project && names_format(path))
    return ExportFile{FileTask::export_layout, path, path == dialog.exists, dialog.width, dialog.height};
  const std::string extension = row_of(dialog.task).extension;
  const bool complete = path.ends_with(extension) || (dialog.task == FileTask::export_layout && names_format(path)) ||
                        (dialog.task == FileTask::export_plot && path.ends_with(".pdf"));
  const std::string whole = complete ? path : path + extension;
  const bool replace = whole == dialog.exists;
  if (dialog.task == FileTask::save_project) return SaveProject{whole, replace};
  if (dialog.task == FileTask::save_scene) return SaveScene{whole, replace};
  return ExportFile{dialog.task, whole, replace, dialog.width, dialog.height};
}

namespace {

/// Returns whether the desktop's dialog has asked about replacing a file. It does not ask about folders, and does not
/// know that another program has changed the document's file.
bool has_asked_about(const std::string& path, const std::vector<FileNotice>& notices) {
  std::error_code ignored;
  const bool is_changed = std::any_of(notices.begin(), notices.end(), [&](const FileNotice& notice) {
    return std::filesystem::equivalent(notice.file, path, ignored);
  });
  return !is_changed && !std::filesystem::is_directory(path, ignored);
}

}  // namespace

bool DesktopDialog::update(const DesktopDialogStage& stage, const std::vector<std::string>& geoms) {
  const bool is_requested = std::exchange(stage.dialog.waits_for_desktop, false);
  if (is_requested && asked_) refuse(stage);
  if (is_requested && !asked_) open(stage.dialog, geoms);
  const std::optional<os::FileReply> reply = asked_ ? chooser_->poll() : std::nullopt;
  if (reply) finish(stage, *reply);
  return is_requested || reply;
}

void DesktopDialog::leave_document() {
  if (!asked_ || asked_->task == FileTask::open) return;
  chooser_->close();
  asked_.reset();
}

void DesktopDialog::open(FileDialog& dialog, const std::vector<std::string>& geoms) {
  asked_ = dialog;
  geoms_ = geoms;
  chooser_->open(desktop_question(dialog));
}

void DesktopDialog::refuse(const DesktopDialogStage& stage) const {
  add_message(stage.messages, Severity::note,
              fmt::format("The desktop's file dialog is open already: {}", row_of(asked_->task).title), stage.now,
              Holds::while_dialog_is_open);
  // A command that waits until the document is saved would wait for a dialog that asks for something else.
  const bool is_for_save = stage.dialog.task == FileTask::save_project && asked_->task != FileTask::save_project;
  if (is_for_save) stage.ui.post(DialogClosed{});
}

void DesktopDialog::finish(const DesktopDialogStage& stage, const os::FileReply& reply) {
  FileDialog asked = *std::exchange(asked_, std::nullopt);
  FileDialog& dialog = stage.dialog;
  if (reply.kind == os::FileReply::Kind::cancelled) return stage.ui.post(DialogClosed{});
  if (reply.kind == os::FileReply::Kind::chosen) {
    asked.exists = has_asked_about(reply.path, stage.notices) ? reply.path : "";
    if (!dialog.open) {  // the next dialog continues here, also if the file cannot be written
      dialog.task = asked.task;
      dialog.folder = parent_of(reply.path);
      dialog.path = reply.path;
    }
    return stage.ui.post(file_command(asked, geoms_, reply.path));
  }
  add_message(
      stage.messages, Severity::warning,
      fmt::format("The desktop's file dialog ended with an error ({}). The window's own dialog is open instead.",
                  reply.problem),
      stage.now);
  if (dialog.open) return;
  begin_own_dialog(dialog, asked.task);
  dialog.path = asked.path;
  stage.ui.post(ListFolder{asked.folder});
}

}  // namespace taxel::ui
