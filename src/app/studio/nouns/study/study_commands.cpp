#include "app/studio/nouns/study/study_commands.h"

#include <imgui.h>

#include <utility>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/host/episodes/episode_document.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/ask_for_file.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/study/study.h"
#include "app/studio/nouns/study/study_state.h"
#include "core/base/error.h"

namespace taxel::studio {

/// The displayed study is written in the background.
void carry_out(const ui::SaveStudy& command, Host& host) {
  if (command.path.empty()) return ask_for_file(host.app, ui::FileTask::save_study, "");
  ui::StudyState& study = host.app.get<ui::StudyState>();
  study.save = ui::StudySaveRequest{++study.save_number, command.path};
}

void carry_out(const ui::OpenStudy& command, Host& host) {
  if (command.path.empty()) return ask_for_file(host.app, ui::FileTask::open_study, "");
  const auto folder = data_set_folder(command.path);
  if (!folder) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error,
                    command.path + ": is no data set: choose the file meta/info.json of one", ImGui::GetTime());
    return;
  }
  ui::StudyState& study = host.app.get<ui::StudyState>();
  study.problem.clear();
  study.cancelled = false;
  study.before = std::move(study.request);
  study.request = ui::StudyRequest{++study.number, {}, folder->string()};
  host.app.get<ui::PanelsShown>()[ui::kStudy] = true;
}

}  // namespace taxel::studio
