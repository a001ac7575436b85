// Opens data sets, and episodes of data sets as documents.
#include "app/studio/app/dump/settings.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/episodes/episode_document.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

/// Begins to read a data set. The open document stays.
void Studio::read_data_set(const std::string& folder) {
  ui::DataSetState& state = app_.simulate->data_set;
  const std::uint64_t number = state.request ? state.request->number + 1 : 1;
  state.request = ui::DataSetRequest{number, folder};
}

void Studio::show_data_set(const DataSetRead& read) {
  if (!read.is_good) return;
  outcome_.has_opened = true;
  app_.window->panels.data_set = true;
  app_.simulate->data_set.wants_focus = true;
  remember_recent(app_.window->recent, read.folder);
}

void Studio::carry_out(const ui::OpenEpisode& episode) {
  files_.layout_without_mesh.clear();
  session_.open(EpisodeChoice{episode.folder, episode.episode});
}

/// The displayed study is written in the background.
void Studio::carry_out(const ui::SaveStudy& command) {
  if (command.path.empty()) return ask_for_file(ui::FileTask::save_study, "");
  ui::StudyState& study = app_.simulate->study;
  study.save = ui::StudySaveRequest{++study.save_number, command.path};
}

void Studio::carry_out(const ui::OpenStudy& command) {
  if (command.path.empty()) return ask_for_file(ui::FileTask::open_study, "");
  const auto folder = data_set_folder(command.path);
  if (!folder) {
    ui::add_message(app_.window->messages, Severity::error,
                    command.path + ": is no data set: choose the file meta/info.json of one", ImGui::GetTime());
    return;
  }
  ui::StudyState& study = app_.simulate->study;
  study.problem.clear();
  study.cancelled = false;
  study.before = std::move(study.request);
  study.request = ui::StudyRequest{++study.number, {}, folder->string()};
  app_.window->panels.study = true;
}

}  // namespace taxel::studio
