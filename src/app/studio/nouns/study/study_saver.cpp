#include "app/studio/nouns/study/study_saver.h"

#include <fmt/format.h>

#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/study/study_state.h"
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

namespace {

class StudyOfFeature final : public FeatureJob {
 public:
  explicit StudyOfFeature(JobExecutor& executor) : study_(executor), saver_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& /*send*/) override {
    study_.request(app.get<ui::StudyState>().request, model);
    saver_.request(app.get<ui::StudyState>().save, study_.posted());
  }
  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& /*run*/,
                      const SendToSimulation& /*send*/) override {
    return store(curves_, study_.newest());
  }
  void report(HostEvents& events) override {
    const auto newest = saver_.newest();
    if (!store(saved_, newest) || !newest) return;
    const bool is_good = newest->problem.empty();
    events.emplace_back(
        HostMessage{is_good ? Severity::note : Severity::error, is_good ? newest->text : newest->problem});
  }
  void fill(ui::App& app) const override {
    app.get<ui::StudyState>().shown = {curves_, study_.busy(), study_.fraction()};
    app.get<ui::StudyState>().saving = {saver_.busy(), saver_.fraction()};
  }
  [[nodiscard]] bool busy() const override { return study_.busy() || saver_.busy(); }

 private:
  StudyJob study_;
  StudySaver saver_;
  StudyJob::ResultPtr curves_;
  StudySaver::ResultPtr saved_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_study_job(JobExecutor& executor) {
  return std::make_unique<StudyOfFeature>(executor);
}

}  // namespace taxel::studio
