// The readings of one layout at many poses of one object, without a simulation: every pose is a contact of its own, at
// rest. The poses and the results as CSV tables.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/base/progress.h"
#include "core/hydro/hydro_body.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Readings, wrenches and areas of many poses, one row for each pose. The wrench acts on the layout's body, about the
/// origin of frame M and in frame M.
struct PoseReadings {
  int taxels = 0;                ///< number of readings in a row
  std::vector<double> readings;  ///< rows in layout order, in reading_unit() of the aggregate
  std::vector<double> wrenches;  ///< rows of force x, y, z [N] and torque x, y, z [N m]
  std::vector<double> areas;     ///< area of the contact surface of each pose [m^2]

  [[nodiscard]] std::size_t pose_count() const { return areas.size(); }
};

/// Options of read_poses().
struct PoseReadingOptions {
  int threads = 0;               ///< largest number of threads; 0 for all cores
  Progress* progress = nullptr;  ///< gets the progress and may cancel; or null
};

/// Reads `model` at each pose X_MO of `object` in the layout's frame M. The bodies are at rest, so that neither damping
/// nor friction acts. Each row has the bits of evaluate_contact() and read_sensor() of a case with this pose and the
/// layout at the origin, whatever the number of threads. Nothing is prepared again between poses. Throws Error if both
/// bodies are rigid, Error("", "/poses/N", ...) for a pose that is not finite or not of unit length, and Cancelled.
PoseReadings read_poses(const SensorModel& model, const HydroBody& object, std::span<const Pose> poses,
                        const PoseReadingOptions& options = {});

/// Largest difference of the length of a pose's quaternion from 1, for values that were rounded to four digits.
inline constexpr double kPoseUnit = 1e-3;

/// Returns poses from rows of seven numbers: position x, y, z [m] and quaternion w, x, y, z. A quaternion is normalised
/// as in a contact case (unit_quaternion()). Throws Error("", "/poses/N", ...) for a number that is not finite, and for
/// a quaternion whose length differs from 1 by more than kPoseUnit.
std::vector<Pose> poses_from_rows(std::span<const double> numbers);

/// Reads poses from a table with the columns x, y, z, qw, qx, qy and qz in any order. Lengths are in metres, or in the
/// unit in the head of their column ("x [mm]"). `unread` (optional) receives the names of the other columns. Throws
/// Error(file, "line N, column x", ...): a column is missing or is in the table twice, a unit that is not a length, a
/// field that is not a finite number, a quaternion as for poses_from_rows(), a table without rows.
std::vector<Pose> parse_poses_csv(const std::string& text, const std::string& file,
                                  std::vector<std::string>* unread = nullptr);

/// Returns a CSV table of poses and their readings: x, y, z [m], qw, qx, qy, qz, force_x, force_y, force_z [N],
/// torque_x, torque_y, torque_z [N m], area [m^2], and taxel_ID for each taxel. Numbers have all their digits.
std::string pose_readings_to_csv(const Layout& layout, std::span<const Pose> poses, const PoseReadings& readings);

}  // namespace taxel
