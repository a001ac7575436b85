#include <algorithm>
#include <memory>

#include "core/run/motion/motion.h"
#include "core/run/recording/recording_files.h"

namespace taxel {

void lead_finger(Motion& motion, const MotionInput&, const scenarios::Replay& replay) {
  const Recording recording = read_moved_recording(replay.source);
  const auto poses = std::make_shared<const std::vector<Pose>>(recording.mocap);
  motion.timestep = recording.timestep;
  motion.X_start = poses->front();
  end_after(motion, replay.record_interval, static_cast<double>(poses->size() - 1) * motion.timestep);
  motion.last_step = poses->size() - 1;
  motion.pose = [poses](std::uint64_t step) { return (*poses)[std::min<std::size_t>(step, poses->size() - 1)]; };
  constexpr std::size_t kMaxWayPoints = 12;  // a user can still move each of them
  const std::size_t n = std::min(kMaxWayPoints, poses->size());
  for (std::size_t i = 0; i < n; ++i) add_way_point(motion, n > 1 ? i * (poses->size() - 1) / (n - 1) : 0);
}

}  // namespace taxel
