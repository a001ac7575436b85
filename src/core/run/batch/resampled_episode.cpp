// Resamples an episode to even intervals.
#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/run/batch/episode.h"
#include "core/run/rows_around.h"

namespace taxel {
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
