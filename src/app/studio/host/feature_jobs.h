// The jobs of all features.
#pragma once

#include <memory>
#include <vector>

#include "app/studio/host/jobs/feature_job.h"

namespace taxel::studio {

/// Passes each call to the jobs of all features, in the order of their rows.
class FeatureJobs {
 public:
  explicit FeatureJobs(JobExecutor& executor);

  void request_about_layout(const ui::App& app, const SensorModelPtr& model);
  void request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& send);
  /// Takes the newest results. Returns whether one of them is new.
  bool take_about_layout(const SensorModelPtr& model, bool is_compiled);
  bool take_about_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& send);
  void report(HostEvents& events);
  void fill(ui::App& app) const;
  [[nodiscard]] bool busy() const;
  void model_built(const SensorModelPtr& model);  ///< on any thread
  void note_edit();
  void drop_scene();
  void accept(const StepsRecalled& recalled);

 private:
  std::vector<std::unique_ptr<FeatureJob>> jobs_;
};

}  // namespace taxel::studio
