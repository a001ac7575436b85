#include "core/run/batch/episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/run/rows_around.h"

namespace taxel {
namespace {

void add_pose(std::vector<double>& values, const Pose& pose) {
  for (const double value : {pose.p.x, pose.p.y, pose.p.z, pose.q.w, pose.q.x, pose.q.y, pose.q.z})
    values.push_back(value);
}

/// Throws Error for a number that is not finite.
void check_numbers(const RecordedSensor& sensor, const RecordedRow& row) {
  const SensorRecord& record = row.sensors.front();
  const auto refuse = [&](const std::string& number) {
    throw Error(fmt::format("{} is not finite at step {}: a modulus, velocity or size is too large", number, row.step));
  };
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(record.force_W[i])) refuse("the contact force");
  for (std::size_t k = 0; k < record.readings.size(); ++k)
    if (!std::isfinite(record.readings[k])) refuse(fmt::format("the reading of taxel {}", sensor.taxel_ids[k]));
  for (std::size_t k = 0; k < record.calibrated.size(); ++k)
    if (!std::isfinite(record.calibrated[k]))
      refuse(fmt::format("the calibrated value of taxel {}", sensor.taxel_ids[k]));
  for (std::size_t k = 0; k < record.shear.size(); ++k)
    if (!std::isfinite(record.shear[k].x) || !std::isfinite(record.shear[k].y))
      refuse(fmt::format("the shear of taxel {}", sensor.taxel_ids[k]));
}

void add_to_summary(const RecordedSensor& sensor, const RecordedRow& row, EpisodeSummary& summary) {
  const SensorRecord& record = row.sensors.front();
  summary.largest_force = std::max(summary.largest_force, glm::length(record.force_W));
  for (std::size_t k = 0; k < record.readings.size(); ++k) {
    if (record.readings[k] <= summary.peak) continue;
    summary.peak = record.readings[k];
    summary.peak_taxel = sensor.taxel_ids[k];
  }
}

template <class Vector>
void add_all(std::vector<double>& values, const Vector& vector) {
  for (int i = 0; i < vector.length(); ++i) values.push_back(vector[i]);
}

}  // namespace

Episode episode_of(const Recording& recording, bool has_poses) {
  if (recording.rows.empty()) throw Error("the run has no rows");
  const RecordedSensor& sensor = recording.sensors.front();
  const std::size_t n = sensor.taxel_ids.size();
  Episode episode;
  episode.rows = static_cast<std::int64_t>(recording.rows.size());
  EpisodeColumn time{kTimestamp, 1, false, {}}, travel{kTravel, 1, false, {}}, tactile{kTactile, n, true, {}};
  EpisodeColumn force{kContactForce, 3, true, {}}, calibrated{kCalibrated, n, true, {}}, shear{kShear, 2 * n, true, {}};
  EpisodeColumn pose{kSensorPose, 7, true, {}}, mocap{kMocapPose, 7, true, {}};
  for (const RecordedRow& row : recording.rows) {
    const SensorRecord& record = row.sensors.front();
    check_numbers(sensor, row);
    add_to_summary(sensor, row, episode.summary);
    time.values.push_back(row.time);
    travel.values.push_back(row.travel);
    tactile.values.insert(tactile.values.end(), record.readings.begin(), record.readings.end());
    add_all(force.values, record.force_W);
    calibrated.values.insert(calibrated.values.end(), record.calibrated.begin(), record.calibrated.end());
    for (const dvec2& value : record.shear) add_all(shear.values, value);
    add_pose(pose.values, record.X_WM);
    add_pose(mocap.values, recording.mocap[static_cast<std::size_t>(row.step)]);
  }
  episode.summary.duration = recording.rows.back().time - recording.rows.front().time;
  episode.columns = {std::move(time), std::move(travel), std::move(tactile), std::move(force)};
  if (sensor.calibrated_unit) episode.columns.push_back(std::move(calibrated));
  if (sensor.shear) episode.columns.push_back(std::move(shear));
  if (has_poses) episode.columns.push_back(std::move(pose));
  if (has_poses) episode.columns.push_back(std::move(mocap));
  return episode;
}

EpisodeSensor sensor_of(const Recording& recording) {
  const RecordedSensor& from = recording.sensors.front();
  return {"",
          "",
          "",
          {from.taxel_ids.begin(), from.taxel_ids.end()},
          from.taxel_names,
          from.reading_unit,
          from.calibrated_unit.value_or("")};
}

namespace {

/// Gives the quaternion after the three numbers of a place length 1.
void normalise_rotation(double* pose) {
  dquat q(pose[3], pose[4], pose[5], pose[6]);
  q = glm::normalize(q);
  pose[3] = q.w, pose[4] = q.x, pose[5] = q.y, pose[6] = q.z;
}

EpisodeColumn resampled_column(const EpisodeColumn& column, const std::vector<RowsAround>& rows) {
  const bool is_pose = column.name == kSensorPose || column.name == kMocapPose;
  EpisodeColumn made{column.name, column.width, column.is_list, {}};
  made.values.reserve(rows.size() * column.width);
  for (const RowsAround& row : rows) {
    const double* const a = column.values.data() + row.before * column.width;
    const double* const b = column.values.data() + row.after * column.width;
    double sign = 1;  // q and -q are the same rotation
    if (is_pose && a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0) sign = -1;
    for (std::size_t i = 0; i < column.width; ++i) {
      const double end = is_pose && i >= 3 ? sign * b[i] : b[i];
      made.values.push_back(row.fraction == 0 ? a[i] : (1 - row.fraction) * a[i] + row.fraction * end);
    }
    if (is_pose && row.fraction != 0) normalise_rotation(made.values.data() + made.values.size() - column.width);
  }
  return made;
}

}  // namespace

Episode resampled(const Episode& episode, int fps) {
  constexpr double kRounding = 1e-9;  // of a multiple of 1 / fps
  const auto time =
      std::ranges::find_if(episode.columns, [](const EpisodeColumn& one) { return one.name == kTimestamp; });
  const double first = std::ceil(time->values.front() * fps - kRounding),
               last = std::floor(time->values.back() * fps + kRounding);
  std::vector<double> times;
  std::vector<RowsAround> rows;
  for (double k = first; k <= std::max(first, last); ++k) {
    times.push_back(k / fps + 0.0);  // not -0
    rows.push_back(rows_around(time->values, k / fps));
  }
  Episode made;
  made.rows = static_cast<std::int64_t>(rows.size());
  made.summary = episode.summary;
  for (const EpisodeColumn& column : episode.columns) {
    made.columns.push_back(resampled_column(column, rows));
    if (column.name == kTimestamp) made.columns.back().values = times;
  }
  return made;
}

}  // namespace taxel
