#include "core/run/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/limits.h"

namespace taxel {

dvec3 lowest_vertex(const TriMesh& skin, const Pose& X_WM) {
  const RigidTransform R(X_WM);
  dvec3 lowest_M(0);
  double z = std::numeric_limits<double>::infinity();
  for (const dvec3& v : skin.vertices()) {
    const double at = R(v).z;
    if (at < z) z = at, lowest_M = v;
  }
  return lowest_M;
}

dvec3 lead_point(const TriMesh& skin, const Pose& X_WM) {
  const RigidTransform R(X_WM);
  Aabb box;
  for (const dvec3& v : skin.vertices()) box.include(R(v));
  const dvec3 lowest = R(lowest_vertex(skin, X_WM));
  return R.inverse_point({lowest.x, box.center().y, lowest.z});
}

double Motion::rows(std::uint64_t step) const {
  return std::floor(static_cast<double>(step) / steps_per_row);
}

bool Motion::row_due(std::uint64_t step) const {
  return step <= last_step && (step == 0 || rows(step) > rows(step - 1));
}

dquat finger_orientation(const SensorFrame& frame, double tilt_deg) {
  const dvec3 distal = glm::normalize(frame.distal);
  const dvec3 pad = glm::normalize(frame.pad - glm::dot(frame.pad, distal) * distal);
  const double tilt = tilt_deg * kPi / 180.0, c = std::cos(tilt), s = std::sin(tilt);
  const dmat3 axes_M(distal, pad, glm::cross(distal, pad));
  const dmat3 axes_W(dvec3(c, 0, -s), dvec3(-s, 0, -c), dvec3(0, 1, 0));
  return glm::normalize(glm::quat_cast(axes_W * glm::transpose(axes_M)));
}

Pose place_finger(const TriMesh& skin, const dquat& q_WM, const dvec3& place) {
  const Pose turned{q_WM, dvec3(0)};
  return {q_WM, place - turned * lead_point(skin, turned)};
}

dvec2 clear_reach(const TriMesh& skin, const Pose& X_WM, double crest, double round) {
  const RigidTransform to_world(X_WM);
  const double lowest_x = to_world(lowest_vertex(skin, X_WM)).x;
  double lowest_z = crest, front = lowest_x, back = lowest_x;
  const auto include = [&](double x) { front = std::max(front, x), back = std::min(back, x); };
  for (int f = 0; f < skin.face_count(); ++f) {
    for (int k = 0; k < 3; ++k) {  // the part of the face below the crest is spanned by these points
      const dvec3 a = to_world(skin.vertex(f, k)), b = to_world(skin.vertex(f, (k + 1) % 3));
      if (a.z < crest) include(a.x);
      if ((a.z < crest) != (b.z < crest)) include(a.x + (crest - a.z) / (b.z - a.z) * (b.x - a.x));
      lowest_z = std::min(lowest_z, a.z);
    }
  }
  const double half_width = crest - lowest_z + round;  // largest half width of the object within the finger's reach
  return {front - lowest_x + half_width, lowest_x - back + half_width};
}

Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object) {
  Motion motion;
  motion.timestep = scenario.timestep;
  const MotionInput input{skin, frame, scenario, object};
  std::visit([&](const auto& kind) { lead_finger(motion, input, kind); }, scenario.motion);
  motion.lead_M = lead_point(skin, motion.X_start);
  return motion;
}

void end_after(Motion& motion, double record_interval, double seconds) {
  motion.steps_per_row = without_rounding(record_interval / motion.timestep);
  motion.last_step = last_step_of(seconds / motion.timestep);
}

void add_way_point(Motion& motion, std::uint64_t step) {
  motion.way_points.push_back({static_cast<double>(step) * motion.timestep, motion.pose(step)});
}

std::uint64_t last_step_of(double steps) {
  check_steps(steps, "the scenario");
  return static_cast<std::uint64_t>(std::ceil(without_rounding(steps)));
}

double without_rounding(double x) {
  const double nearest = std::round(x);
  return std::abs(x - nearest) <= 1e-9 * nearest ? nearest : x;
}

void lead_pressed(Motion& motion, const MotionInput& input, const scenarios::Pressed& pressed,
                  const PartAtDepth& part_at_depth) {
  const dvec3 touch(input.object.center().x + pressed.place, 0, input.object.hi.z);
  const double drop = pressed.clearance + pressed.depth;
  motion.X_start = place_finger(input.skin, finger_orientation(input.frame, pressed.tilt_deg),
                                touch + dvec3(0, 0, pressed.clearance));
  const auto lowered = [X = motion.X_start, drop](double u) { return Pose{X.q, X.p - dvec3(0, 0, u * drop)}; };
  const dvec3 lowest_W = motion.X_start * lowest_vertex(input.skin, motion.X_start) - dvec3(0, 0, drop);
  const MotionPart at_depth = part_at_depth(lowered(1), lowest_W);
  std::vector<MotionPart> parts{{drop / pressed.speed, lowered},
                                at_depth,
                                {pressed.hold, [at_depth](double) { return at_depth.pose(1); }},
                                {at_depth.seconds, [at_depth](double u) { return at_depth.pose(1 - u); }},
                                {drop / pressed.speed, [lowered](double u) { return lowered(1 - u); }}};
  std::erase_if(parts, [](const MotionPart& part) { return !(part.seconds > 0); });
  double end = 0;
  motion.way_points.push_back({0, motion.X_start});
  for (const MotionPart& part : parts) motion.way_points.push_back({end += part.seconds, part.pose(1)});
  end_after(motion, pressed.record_interval, end);
  motion.pose = [parts, timestep = motion.timestep](std::uint64_t step) {
    double t = static_cast<double>(step) * timestep;
    for (const MotionPart& part : parts) {
      if (t < part.seconds) return part.pose(t / part.seconds);
      t -= part.seconds;
    }
    return parts.back().pose(1);
  };
}

}  // namespace taxel
