// Readings of one step by other models of a taxel, for comparison. They have no influence on the simulation.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/run/frame.h"
#include "core/sensor/compare/reading_models.h"

namespace taxel {

class MujocoSensors;

/// Comparison of the models for one sensor of a scene. May be used by one thread at a time.
class ModelComparison {
 public:
  /// Compiles the sensor's layout with a star-shaped field, and its bodies for MuJoCo. If a model cannot be built, its
  /// readings have the reason. Throws Error if the scene has no such sensor, and throws Cancelled.
  ModelComparison(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress = nullptr);
  ~ModelComparison();
  ModelComparison(const ModelComparison&) = delete;
  ModelComparison& operator=(const ModelComparison&) = delete;

  [[nodiscard]] const std::shared_ptr<const SimScene>& scene() const { return scene_; }
  [[nodiscard]] std::size_t sensor() const { return sensor_; }

  /// Returns the readings of one step. `sensors` has all sensors of the scene, `X_WG` the poses of all its geoms. The
  /// result depends on these arguments only.
  [[nodiscard]] ModelReadings read(std::span<const SensorStep> sensors, std::span<const Pose> X_WG);

 private:
  void read_star(std::span<const SensorStep> sensors, std::span<const Pose> X_WB, ModelReading& out);
  void read_exact(const SensorStep& state, ModelReading& out) const;
  void read_mujoco(const SensorStep& state, std::span<const SensorStep> sensors, const std::vector<Pose>& X_WB,
                   ModelReadings& out);

  std::shared_ptr<const SimScene> scene_;
  std::size_t sensor_;
  SensorModelPtr star_;
  std::string no_star_, no_mujoco_;  // reasons why a model could not be built; empty if it was
  std::unique_ptr<MujocoSensors> mujoco_;
};

}  // namespace taxel
