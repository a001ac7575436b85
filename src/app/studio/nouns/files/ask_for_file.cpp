#include "app/studio/nouns/files/ask_for_file.h"

#include "app/studio/frame/shown.h"
#include "app/studio/host/document/project_files.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/file_dialog_tool.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/files/file_task.h"

namespace taxel::studio {

void ask_for_file(ui::App& app, ui::FileTask task, const std::string& problem) {
  const bool again = app.get<ui::FileDialog>().task == task && !problem.empty();
  const std::string typed = app.get<ui::FileDialog>().path;
  problem.empty() ? ui::begin_dialog(app.get<ui::FileDialog>(), task)
                  : ui::begin_own_dialog(app.get<ui::FileDialog>(), task);
  const bool folder = task == ui::FileTask::export_recording || task == ui::FileTask::keep_recording;
  const SuggestedFile suggested = suggested_file(app.shown->document.file, app.shown->document.name,
                                                 folder                               ? "-recording"
                                                 : task == ui::FileTask::export_video ? "-video.mp4"
                                                                                      : ui::row_of(task).extension);
  list_folder(app.get<ui::FileDialog>(),
              suggested.folder.empty() || again ? app.get<ui::FileDialog>().folder : suggested.folder);
  app.get<ui::FileDialog>().path = again ? typed : suggested.name;
  app.get<ui::FileDialog>().error = problem;
}

}  // namespace taxel::studio
