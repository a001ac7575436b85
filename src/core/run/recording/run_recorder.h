// Makes a recording of steps, whoever makes them: the command line's loop, the window's simulation, or its history.
#pragma once

#include <optional>
#include <vector>

#include "core/run/history/step_view.h"
#include "core/run/recording/recording.h"
#include "core/sensor/calibration.h"

namespace taxel {

/// What the columns of a scene's recording mean; no rows yet.
Recording describe_recording(const SimScene& scene);

/// Memory that one row of a scene's recording takes [bytes].
std::size_t recorded_row_bytes(const SimScene& scene);

/// Returns a step as a row of a recording, without calibrated values; its RecordedRow::step is 0.
RecordedRow row_of(const StepView& step);

/// Collects rows of one scene, one step after the other. Calibrations begin with the first step: a loop or a held value
/// depends on all that was felt since.
class RunRecorder {
 public:
  explicit RunRecorder(const SimScene& scene);

  /// The step of `view`, during which the mocap body was at `mocap`; `keep`: it becomes a row.
  void follow(const StepView& view, const Pose& mocap, bool keep);

  [[nodiscard]] const Recording& recording() const { return recording_; }
  [[nodiscard]] Recording take() { return std::move(recording_); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }  ///< of rows and mocap poses, about

  /// Forgets all that was followed after the first `steps` steps. Where there is a calibration, each must have been
  /// kept: it runs through them anew.
  void cut_after(std::size_t steps);

 private:
  void begin_calibrations();

  Recording recording_;
  std::vector<SensorModelPtr> sensors_;
  std::vector<std::optional<Calibrator>> calibrators_;  // per sensor
  std::vector<std::vector<double>> calibrated_;         // after the latest step, per sensor
  bool any_calibration_ = false;
  std::size_t bytes_ = 0;
};

}  // namespace taxel
