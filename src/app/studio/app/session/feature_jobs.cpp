#include "app/studio/app/session/feature_jobs.h"

#include <utility>

#include "app/studio/app/app.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/features/compare/compare_tool.h"
#include "app/studio/features/data_set/episode_list.h"
#include "app/studio/features/explain/explain_tool.h"
#include "app/studio/features/measure/measure_tool.h"
#include "app/studio/features/models/models_tool.h"
#include "app/studio/features/probe/probe_tool.h"

namespace taxel::studio {
namespace {

/// Stores a result. Returns whether it differs from the previous one.
template <class Ptr>
bool store(Ptr& stored, Ptr newest) {
  if (newest == stored) return false;
  stored = std::move(newest);
  return true;
}

}  // namespace

FeatureJobs::FeatureJobs(JobExecutor& executor)
    : executor_(executor),
      probe_(executor),
      measure_(executor),
      fields_(executor),
      explain_(executor),
      models_(executor),
      compare_(executor),
      study_(executor),
      study_saver_(executor),
      data_set_(executor),
      patterns_(executor),
      error_bars_(executor) {}

void FeatureJobs::model_built(const SensorModelPtr& model) {
  probe_.model_built(model);
  fields_.model_built(model);
}

bool FeatureJobs::busy() const {
  return probe_.busy() || measure_.busy() || fields_.busy() || explain_.busy() || models_.busy() || compare_.busy() ||
         study_.busy() || study_saver_.busy() || data_set_.busy() || error_bars_.busy();
}

void FeatureJobs::request_about_layout(const ui::App& app, const SensorModelPtr& model) {
  probe_.request(ui::probe_request(*app.viewer, app.layout->probe), model);
  measure_.post(ui::measure_request(*app.viewer, app.shown->document, app.layout->measure));
  const ui::Overlays& overlays = app.viewer->overlays();
  fields_.request(app.viewer->mode, ui::field_map(overlays), overlays.readings_on_skin, overlays.reading_discs);
}

void FeatureJobs::request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& send) {
  explain_.request(ui::explain_request(*app.viewer, *app.shown, app.window->panels.explain), send);
  error_bars_.request(app.viewer->mode == ui::Mode::simulate && app.simulate->error_bars.on);
  models_.compare(ui::models_request(*app.viewer, *app.shown, app.window->panels.models));
  const ui::CompareState& compare = app.simulate->compare;
  const auto second = ui::compare_request(*app.viewer, *app.shown, compare, app.window->panels.compare);
  compare_.compare(second ? std::optional(CompareJob::Request{*second, app.viewer->selection.sensor, compare.stopped})
                          : std::nullopt);
  study_.request(app.simulate->study.request, model);
  study_saver_.request(app.simulate->study.save, study_.posted());
  data_set_.request(app.simulate->data_set.request, ui::episode_request(app.simulate->data_set));
}

bool FeatureJobs::update_layout(const SensorModelPtr& model, bool is_compiled) {
  probe_.post_for(model);
  executor_.run_posted();
  const bool is_measured = store(measured_, measure_.newest());
  return probe_.take_result(model, is_compiled) || is_measured;
}

bool FeatureJobs::update_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& send) {
  fields_.post_for(model, run.frame);
  executor_.run_posted();
  bool is_new = fields_.is_current() && store(shown_fields_, fields_.newest());
  error_bars_.follow(run.frame);
  executor_.run_posted();
  is_new = store(measured_errors_, error_bars_.newest()) || is_new;
  if (const std::optional<RecallCommand> recall = explain_.follow(run.frame, run.keeps_explanation)) send(*recall);
  executor_.run_posted();
  is_new = store(explained_, explain_.newest()) || is_new;
  if (const std::optional<RecallCommand> recall = models_.follow(run.frame, run.runs)) send(*recall);
  executor_.run_posted();
  if (const std::optional<RecallCommand> recall = compare_.follow(run.frame, run.runs)) send(*recall);
  executor_.run_posted();
  is_new = store(compared_layouts_, compare_.newest()) || is_new;
  return store(compared_, models_.newest()) || is_new;
}

std::shared_ptr<const SavedStudy> FeatureJobs::take_saved_study() {
  const auto newest = study_saver_.newest();
  return store(saved_study_, newest) ? newest : nullptr;
}

void FeatureJobs::fill(ui::App& app) const {
  app.shown->document.probe = probe_.reading();
  app.layout->probe.latency = probe_.edit_latency();
  app.shown->document.measured = measured_;
  app.shown->document.fields = shown_fields_;
  app.shown->run.errors = measured_errors_;
  app.simulate->explain.explained = explained_;
  app.simulate->models.compared = compared_;
  app.simulate->compare.compared = compared_layouts_;
  app.simulate->compare.progress = compare_.progress();
  app.simulate->study.shown = {study_.newest(), study_.busy(), study_.fraction()};
  app.simulate->study.saving = {study_saver_.busy(), study_saver_.fraction()};
  ui::show_data_set(app.simulate->data_set, data_set_.set(), data_set_.curves());
  app.simulate->data_set.is_reading = data_set_.is_reading_set();
}

}  // namespace taxel::studio
