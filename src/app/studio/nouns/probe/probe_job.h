// Presses the probe on a worker: the newest pose wins, so that the probe follows the pointer without delay.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "ui/scene/scene_input.h"

namespace taxel::studio {

struct ProbeInput {
  SensorModelPtr model;
  Probe probe;
  bool operator==(const ProbeInput&) const = default;
};

class ProbeJob : public NewestWins<ProbeInput, ui::PressedProbe> {
 public:
  explicit ProbeJob(JobExecutor& executor);

  /// Sets the probe to press, and presses the probe on `model`. Without a probe there is no reading.
  void request(std::optional<Probe> probe, const SensorModelPtr& model);
  /// Presses the requested probe on a model, which may be another one than before.
  void post_for(const SensorModelPtr& model) { press(model, request_); }
  /// Takes the newest result for `model`. Returns whether the reading is a new one. `is_compiled`: the model includes
  /// all edits.
  bool take_result(const SensorModelPtr& model, bool is_compiled);
  /// The taken reading; null without one for the model.
  [[nodiscard]] const ui::PressedProbePtr& reading() const { return reading_; }
  /// Registers an edit, from which edit_latency() is measured.
  void note_edit();
  /// Time from the last edit to its reading [s]; empty until it is read.
  [[nodiscard]] std::optional<double> edit_latency() const { return edit_latency_; }

  /// Posts a press. Without a probe or a model, the reading is removed.
  void press(const SensorModelPtr& model, const std::optional<Probe>& probe);
  /// Presses the requested probe on a model that was just built, on the worker that built it, so that the model and its
  /// reading arrive together.
  void model_built(const SensorModelPtr& model);

 private:
  std::optional<Probe> request_;
  ui::PressedProbePtr reading_;
  /// Time of an edit that the reading does not include.
  std::optional<std::chrono::steady_clock::time_point> edited_at_;
  std::optional<double> edit_latency_;
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_probe_job(JobExecutor& executor);

}  // namespace taxel::studio
