#include "app/studio/features/study/study_saver.h"

#include <fmt/format.h>

#include <utility>

#include "app/version/version.h"
#include "core/sim/study/save_study.h"

namespace taxel::studio {
namespace {

void write_study(const StudySave& save, SavedStudy& saved, Progress& progress) {
  saved.folder = save.request.folder;
  const DataSetCounts counts =
      save_study({save.input.request.study, save.input.model, save.request.folder, version_line("taxel")}, progress);
  saved.text = fmt::format("Wrote {} runs as a data set: {}", counts.episodes, save.request.folder);
  if (!counts.failed.empty()) saved.text += fmt::format(" ({} runs failed)", counts.failed.size());
}

}  // namespace

StudySaver::StudySaver(JobExecutor& executor) : NewestWins(executor, Priority::background, write_study) {}

void StudySaver::request(const std::optional<ui::StudySaveRequest>& request, const std::optional<StudyInput>& input) {
  if (!request) return post(std::nullopt, Superseded::cancel);
  const std::optional<StudySave> known = posted();
  if ((known && known->request == *request) || !input) return;
  post(StudySave{*request, *input}, Superseded::cancel);
}

}  // namespace taxel::studio
