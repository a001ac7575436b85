// Opens data sets, and episodes of data sets as documents.
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/host/episodes/episode_document.h"
#include "app/studio/nouns/data_set/data_set.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/study/study.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/shell/state/settings.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

/// Begins to read a data set. The open document stays.
void Studio::read_data_set(const std::string& folder) {
  ui::DataSetState& state = app_.get<ui::DataSetState>();
  const std::uint64_t number = state.request ? state.request->number + 1 : 1;
  state.request = ui::DataSetRequest{number, folder};
}

void Studio::show_data_set(const DataSetRead& read) {
  if (!read.is_good) return;
  outcome_.has_opened = true;
  app_.get<ui::PanelsShown>()[ui::kDataSet] = true;
  app_.get<ui::DataSetState>().wants_focus = true;
  remember_recent(app_.get<ui::FilesState>().recent, read.folder);
}

void Studio::carry_out(const ui::OpenEpisode& episode) {
  files_.layout_without_mesh.clear();
  session_.open(EpisodeChoice{episode.folder, episode.episode});
}

/// The displayed study is written in the background.
void Studio::carry_out(const ui::SaveStudy& command) {
  if (command.path.empty()) return ask_for_file(ui::FileTask::save_study, "");
  ui::StudyState& study = app_.get<ui::StudyState>();
  study.save = ui::StudySaveRequest{++study.save_number, command.path};
}

void Studio::carry_out(const ui::OpenStudy& command) {
  if (command.path.empty()) return ask_for_file(ui::FileTask::open_study, "");
  const auto folder = data_set_folder(command.path);
  if (!folder) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error,
                    command.path + ": is no data set: choose the file meta/info.json of one", ImGui::GetTime());
    return;
  }
  ui::StudyState& study = app_.get<ui::StudyState>();
  study.problem.clear();
  study.cancelled = false;
  study.before = std::move(study.request);
  study.request = ui::StudyRequest{++study.number, {}, folder->string()};
  app_.get<ui::PanelsShown>()[ui::kStudy] = true;
}

}  // namespace taxel::studio
