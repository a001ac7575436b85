// The contact of one step read by other models of a taxel. Nothing of it reaches the simulation.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/run/frame.h"
#include "core/sensor/compare/reading_models.h"

namespace taxel {

class MujocoSensors;

/// Of one sensor of a scene. Belongs to one thread at a time.
class ModelComparison {
 public:
  /// Compiles the sensor's layout with a star field, and its bodies for MuJoCo; what of it cannot be is told in the
  /// readings. Throws Error for a sensor that the scene does not have, and Cancelled.
  ModelComparison(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress = nullptr);
  ~ModelComparison();
  ModelComparison(const ModelComparison&) = delete;
  ModelComparison& operator=(const ModelComparison&) = delete;

  [[nodiscard]] const std::shared_ptr<const SimScene>& scene() const { return scene_; }
  [[nodiscard]] std::size_t sensor() const { return sensor_; }

  /// A step as it was recorded or computed: all sensors of the scene, X_WG of all its geoms. A pure function of these.
  [[nodiscard]] ModelReadings read(std::span<const SensorStep> sensors, std::span<const Pose> X_WG);

 private:
  void read_star(std::span<const SensorStep> sensors, std::span<const Pose> X_WB, ModelReading& out);
  void read_exact(const SensorStep& state, ModelReading& out) const;
  void read_mujoco(const SensorStep& state, std::span<const SensorStep> sensors, const std::vector<Pose>& X_WB,
                   ModelReadings& out);

  std::shared_ptr<const SimScene> scene_;
  std::size_t sensor_;
  SensorModelPtr star_;
  std::string no_star_, no_mujoco_;  // why not
  std::unique_ptr<MujocoSensors> mujoco_;
};

}  // namespace taxel
