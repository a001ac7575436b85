// Makes a recording of steps, for the command line, the window's simulation, and the window's history.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"
#include "core/run/step.h"
#include "core/sensor/calibration.h"

namespace taxel {

/// Measures error bars of readings. Belongs to one thread.
class ErrorBarSource {
 public:
  virtual ~ErrorBarSource() = default;
  /// Returns why a sensor of the scene has no error bars, or an empty text.
  [[nodiscard]] virtual std::string missing(std::size_t sensor) const = 0;
  /// Returns one bar per taxel of a sensor, in the unit of the readings. Throws Error for a sensor without error bars,
  /// or if they cannot be measured in this step.
  virtual std::vector<double> measure(const StepView& step, std::size_t sensor) = 0;
};

/// Returns the recording of a scene without rows: the meaning of its columns.
Recording describe_recording(const SimScene& scene);

/// Returns the memory that one row of a scene's recording takes [bytes].
std::size_t recorded_row_bytes(const SimScene& scene);

/// Returns a step as a row of a recording, without calibrated values; its RecordedRow::step is 0.
RecordedRow row_of(const StepView& step);

/// Collects rows of one scene, step by step. Calibrations begin at the first step, because hysteresis and held values
/// depend on all readings since then.
class RunRecorder {
 public:
  /// `errors`, which may be null, measures the error bars of each row.
  explicit RunRecorder(const SimScene& scene, std::shared_ptr<ErrorBarSource> errors = nullptr);

  /// Follows the step `view`, during which the mocap body had the pose `mocap`. Adds a row if `keep`. Throws the errors
  /// of ErrorBarSource::measure(); then no row is added.
  void follow(const StepView& view, const Pose& mocap, bool keep);

  /// Returns whether follow() needs every step: a calibration depends on all readings.
  [[nodiscard]] bool needs_every_step() const { return any_calibration_; }
  /// Follows a step without a row, unless every step is needed.
  void pass(const Pose& mocap);

  [[nodiscard]] const Recording& recording() const { return recording_; }
  [[nodiscard]] Recording take() { return std::move(recording_); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }  ///< approximate size of rows and mocap poses

  /// Forgets all steps after the first `steps`. With a calibration every step must have a row, because the calibration
  /// runs through the remaining rows again.
  void cut_after(std::size_t steps);

 private:
  void begin_calibrations();

  Recording recording_;
  std::vector<SensorModelPtr> sensors_;
  std::shared_ptr<ErrorBarSource> errors_;
  std::vector<std::optional<Calibrator>> calibrators_;  // by sensor
  std::vector<std::vector<double>> calibrated_;         // values of the latest step, by sensor
  bool any_calibration_ = false;
  std::size_t bytes_ = 0;
};

}  // namespace taxel
