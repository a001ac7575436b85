#include "app/studio/host/jobs/feature_job.h"

#include <algorithm>

#include "app/studio/frame/feature.h"

namespace taxel::studio {

FeatureJobs::FeatureJobs(JobExecutor& executor) {
  for (const ui::Feature* row : ui::features())
    if (row->make_job != nullptr) jobs_.push_back(row->make_job(executor));
}

void FeatureJobs::request_about_layout(const ui::App& app, const SensorModelPtr& model) {
  for (const auto& job : jobs_) job->request_about_layout(app, model);
}

void FeatureJobs::request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& send) {
  for (const auto& job : jobs_) job->request_about_run(app, model, send);
}

bool FeatureJobs::take_about_layout(const SensorModelPtr& model, bool is_compiled) {
  bool is_new = false;
  for (const auto& job : jobs_) is_new = job->take_about_layout(model, is_compiled) || is_new;
  return is_new;
}

bool FeatureJobs::take_about_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& send) {
  bool is_new = false;
  for (const auto& job : jobs_) is_new = job->take_about_run(model, run, send) || is_new;
  return is_new;
}

void FeatureJobs::report(HostEvents& events) {
  for (const auto& job : jobs_) job->report(events);
}

void FeatureJobs::fill(ui::App& app) const {
  for (const auto& job : jobs_) job->fill(app);
}

bool FeatureJobs::busy() const {
  return std::any_of(jobs_.begin(), jobs_.end(), [](const auto& job) { return job->busy(); });
}

void FeatureJobs::model_built(const SensorModelPtr& model) {
  for (const auto& job : jobs_) job->model_built(model);
}

void FeatureJobs::note_edit() {
  for (const auto& job : jobs_) job->note_edit();
}

void FeatureJobs::drop_scene() {
  for (const auto& job : jobs_) job->drop_scene();
}

void FeatureJobs::accept(const StepsRecalled& recalled) {
  for (const auto& job : jobs_) job->accept(recalled);
}

}  // namespace taxel::studio
