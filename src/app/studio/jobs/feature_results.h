// Requests and results of the features' jobs.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "app/studio/app/values/viewer.h"
#include "app/studio/jobs/feature_jobs.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// The newest results. An earlier result stays until there is one for the displayed model.
class FeatureResults {
 public:
  FeatureResults(JobExecutor& executor, const std::function<void()>& wake)
      : executor_(executor), jobs_(executor, wake) {}

  [[nodiscard]] FeatureJobs& jobs() { return jobs_; }
  [[nodiscard]] const FeatureJobs& jobs() const { return jobs_; }

  /// Presses a probe on a model. Without a probe there is no reading.
  void press(std::optional<Probe> probe, const SensorModelPtr& model);
  /// Sets the receptive fields to compute in `mode`.
  void show_fields(ui::Mode mode, ui::FieldMap map, bool weights);
  /// Sets the taxel to explain. Returns whether the first one is requested, or the last one is no longer requested.
  bool explain(std::optional<ui::ExplainRequest> request);
  void forget_explanation() { explain_request_.reset(); }
  /// Registers an edit, from which the latency of the probe is measured.
  void note_edit();

  /// The functions below post a request and take the newest result. They return whether it is another one.
  bool update_reading(const SensorModelPtr& model, bool is_compiled);
  bool update_fields(const SensorModelPtr& model, const SimFramePtr& frame);
  bool update_explanation(const SimFramePtr& frame, bool keeps_result);
  bool update_comparison();

  /// Sets the results that panels display.
  void fill(ui::App& app) const;
  /// Time from the last edit to the reading of the probe [s]; empty until it is read.
  [[nodiscard]] std::optional<double> edit_latency() const { return edit_latency_; }

 private:
  JobExecutor& executor_;
  FeatureJobs jobs_;
  std::optional<Probe> probe_request_;
  ui::PressedProbePtr pressed_;                                     // reading of the displayed model
  std::optional<std::chrono::steady_clock::time_point> edited_at_;  // time of an edit that the reading does not include
  std::optional<double> edit_latency_;
  ui::MeasuredPtr measured_;
  ui::FieldsRequest field_request_;  // without models
  ui::Mode field_mode_ = ui::Mode::simulate;
  ui::ShownFieldsPtr shown_fields_;
  std::optional<ui::ExplainRequest> explain_request_;
  ui::ExplainedPtr explained_;
  ui::ComparedPtr compared_;
};

}  // namespace taxel::studio
