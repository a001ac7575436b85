// The rows of one run of a scene, as columns: readings and wrenches of all sensors, poses of free bodies, joints and
// actions.
#pragma once

#include <string>
#include <vector>

#include "core/run/batch/episode.h"
#include "core/run/recording/recording.h"
#include "core/run/step.h"

namespace taxel {

/// The values of one row.
struct SceneRow {
  RecordedRow recorded;
  std::vector<dvec3> torques_W;  ///< torque on each sensor about the origin of its frame M [N m]
  std::vector<Pose> bodies;      ///< X_WB, parallel to SceneControls::bodies
  std::vector<double> joints;    ///< parallel to SceneControls::joints
  std::vector<double> controls;  ///< parallel to SceneControls::actuators, in the step that the row evaluates
  std::vector<Pose> mocaps;      ///< parallel to SceneControls::mocaps
};

/// Collects the rows of a scene.
class SceneColumns {
 public:
  /// `key` and `name` are those of EpisodeScene. With `has_poses`, the rows have the poses of the sensors.
  SceneColumns(const SimScene& scene, std::string key, std::string name, bool has_poses);

  /// Adds a row. Throws Error naming the number, the sensor and the step if a number is not finite.
  void add(const SceneRow& row);
  /// Returns the columns so far. Throws Error if there is no row.
  [[nodiscard]] Episode episode() const;
  [[nodiscard]] const EpisodeScene& scene() const { return scene_; }

 private:
  void add_sensor(std::size_t sensor, const SceneRow& row);
  EpisodeColumn& column(const std::string& name, std::size_t width);
  void append(const std::string& name, const std::vector<double>& values);

  EpisodeScene scene_;
  std::vector<RecordedSensor> sensors_;
  std::vector<std::pair<std::string, std::size_t>> bodies_;  // names of columns and indices of free bodies
  bool has_poses_;
  Episode episode_;
};

}  // namespace taxel
