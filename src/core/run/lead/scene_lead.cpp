#include "core/run/lead/scene_lead.h"

#include <algorithm>
#include <cmath>

#include "core/run/rows_around.h"

namespace taxel {

double control_at(const ControlTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  return (1 - rows.fraction) * track.values[rows.before] + rows.fraction * track.values[rows.after];
}

dvec3 position_at(const MocapTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  return (1 - rows.fraction) * track.positions_W[rows.before] + rows.fraction * track.positions_W[rows.after];
}

dquat rotation_at(const MocapTrack& track, double time) {
  const RowsAround rows = rows_around(track.times, time);
  const dquat &before = track.rotations_WB[rows.before], &after = track.rotations_WB[rows.after];
  if (rows.fraction == 0) return before;
  if (rows.fraction == 1) return after;
  return glm::normalize(glm::slerp(before, after, rows.fraction));
}

double end_of(const SceneLead& lead) {
  double end = 0;
  for (const ControlTrack& track : lead.controls) end = std::max(end, track.times.back());
  for (const MocapTrack& track : lead.mocaps) end = std::max(end, track.times.back());
  return end;
}

long steps_of(const SceneLead& lead, double timestep) {
  constexpr double kRounding = 1e-6;  // of a step: times of files are rounded
  constexpr double kMost = 1e15;      // more than any run has
  return std::lround(std::min(kMost, std::ceil(end_of(lead) / timestep - kRounding))) + 1;
}

}  // namespace taxel
