// The results of one job, as columns. Plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/run/recording/recording.h"

namespace taxel {

/// The choices that change the bytes of a batch.
struct BatchFormat {
  bool float64 = false;  ///< numbers have 64 bits instead of 32
  bool poses = false;    ///< poses of the sensor and of the mocap body are recorded
  int group_size = 16;   ///< largest number of jobs of a group
  int fps = 0;           ///< rows a second to which episodes are resampled; 0 keeps the rows of the runs
  bool operator==(const BatchFormat&) const = default;
};

/// A column of numbers: `width` numbers in each row.
struct EpisodeColumn {
  std::string name;       ///< feature of the data set, such as observation.tactile
  std::size_t width = 1;  ///< 1 for a column without lists
  bool is_list = false;
  std::vector<double> values;
};

/// Names of the columns. All but kTimestamp and kTravel are lists.
inline constexpr const char* kTimestamp = "timestamp";                 ///< [s]
inline constexpr const char* kTravel = "observation.travel";           ///< travel of the mocap body [m]
inline constexpr const char* kTactile = "observation.tactile";         ///< readings in the order of the taxels
inline constexpr const char* kCalibrated = "observation.calibrated";   ///< calibrated readings
inline constexpr const char* kShear = "observation.shear";             ///< along e1 and e2 of each taxel
inline constexpr const char* kContactForce = "observation.force";      ///< on the sensor, world frame [N]
inline constexpr const char* kSensorPose = "observation.sensor_pose";  ///< X_WM: x y z [m], then qw qx qy qz
inline constexpr const char* kMocapPose = "action";                    ///< pose of the mocap body, as kSensorPose

// Columns of a scene: the name of a sensor or a body follows in the names with a dot at the end.

inline constexpr const char* kState = "observation.state";               ///< positions of hinges [rad] and slides [m]
inline constexpr const char* kTactileOf = "observation.tactile.";        ///< readings of one sensor
inline constexpr const char* kCalibratedOf = "observation.calibrated.";  ///< calibrated readings
inline constexpr const char* kShearOf = "observation.shear.";            ///< shear of one sensor
inline constexpr const char* kForceOf = "observation.force.";            ///< force on it, world frame [N]
inline constexpr const char* kTorqueOf = "observation.torque.";          ///< about M's origin, world frame [N m]
inline constexpr const char* kSensorPoseOf = "observation.sensor_pose.";
inline constexpr const char* kPoseOf = "observation.pose.";  ///< pose of a body with a free joint

/// Numbers of one run for tables and lists.
struct EpisodeSummary {
  double largest_force = 0;  ///< [N]
  double peak = 0;           ///< largest reading, in the unit of the readings
  int peak_taxel = -1;       ///< id of the taxel with the largest reading, or -1 if all readings are 0
  double duration = 0;       ///< time from the first row to the last [s]
  /// Name of the sensor of `peak_taxel` in a scene; empty for a scenario, or if all readings are 0.
  std::string peak_sensor = {};
  bool operator==(const EpisodeSummary&) const = default;
};

/// The sensor of an episode: the meaning of its columns.
struct EpisodeSensor {
  std::string layout_key;   ///< Job::layout_key
  std::string layout_json;  ///< text of the layout; its mesh is meshes/SHA256.EXTENSION
  std::string layout_name;
  std::vector<std::int64_t> taxel_ids;
  std::vector<std::string> taxel_names;
  std::string unit;             ///< unit of the readings: Pa, Pa m^2 or N
  std::string calibrated_unit;  ///< empty without a calibration
  bool operator==(const EpisodeSensor&) const = default;
};

/// The scene of an episode: the meaning of its columns.
struct EpisodeScene {
  std::string key;                     ///< Job::layout_key
  std::string name;                    ///< name of the scene's file
  std::vector<std::string> sensors;    ///< names of the sensors in the names of columns
  std::vector<EpisodeSensor> layouts;  ///< parallel to `sensors`; without taxels for a soft geom
  std::vector<std::string> state;      ///< names of the joints in kState
  std::string state_unit;              ///< rad, m, or "rad, m" if the joints are of both kinds
  std::vector<std::string> action;     ///< names of the actuators and coordinates of mocap bodies in kMocapPose
  bool operator==(const EpisodeScene&) const = default;
};

struct Episode {
  std::int64_t rows = 0;
  std::vector<EpisodeColumn> columns;
  EpisodeSummary summary;
};

/// Returns the columns of the first sensor of a recording. Throws Error naming step and taxel if a number is not
/// finite, and Error if the recording has no rows.
Episode episode_of(const Recording& recording, bool has_poses);

/// Returns the episode with rows at whole multiples of 1 / fps, interpolated linearly between its rows; quaternions
/// keep length 1. The summary remains that of all rows.
Episode resampled(const Episode& episode, int fps);

/// Returns the description of the first sensor of a recording, without its layout.
EpisodeSensor sensor_of(const Recording& recording);

}  // namespace taxel
