#include "app/studio/nouns/files/file_command.h"

#include "app/studio/nouns/compare/compare_commands.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/scene/scene_commands.h"
#include "app/studio/nouns/study/study_commands.h"
#include "core/layout/formats/format_table.h"

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
  const std::string extension = row_of(dialog.task).extension;
  const bool complete = path.ends_with(extension) || (dialog.task == FileTask::export_layout && names_format(path)) ||
                        (dialog.task == FileTask::export_plot && path.ends_with(".pdf"));
  const std::string whole = complete ? path : path + extension;
  const bool replace = whole == dialog.exists;
  if (dialog.task == FileTask::save_project) return SaveProject{whole, replace};
  if (dialog.task == FileTask::save_scene) return SaveScene{whole, replace};
  return ExportFile{dialog.task, whole, replace, dialog.width, dialog.height};
}

}  // namespace taxel::ui
