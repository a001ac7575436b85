#include "core/run/motion/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/document/scenario/path_curve.h"
#include "core/run/motion/paper_demo.h"
#include "core/run/motion/rolling_outline.h"
#include "core/run/motion/upright_edge.h"
#include "core/run/recording/npz.h"

namespace taxel {
namespace {

constexpr double kRadiansPerDegree = kPi / 180.0;

/// A number that is meant to be whole, freed of its rounding.
double whole(double x) {
  const double nearest = std::round(x);
  return std::abs(x - nearest) <= 1e-9 * nearest ? nearest : x;
}

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

/// In the middle of the width, and as far in front and as low as the lowest point.
dvec3 lead_point(const TriMesh& skin, const Pose& X_WM) {
  const RigidTransform R(X_WM);
  Aabb box;
  for (const dvec3& v : skin.vertices()) box.include(R(v));
  const dvec3 lowest = R(lowest_vertex(skin, X_WM));
  return R.inverse_point({lowest.x, box.center().y, lowest.z});
}

std::uint64_t last_step_of(double steps) {
  check_steps(steps, "the scenario");
  return static_cast<std::uint64_t>(std::ceil(whole(steps)));
}

/// The clock of all but the sweep: rows at even times.
void end_at(Motion& motion, const Scenario& scenario, double seconds) {
  motion.steps_per_row = whole(scenario.record_interval / motion.timestep);
  motion.last_step = last_step_of(seconds / motion.timestep);
}

/// Gap between the finger and an upright edge at the start and at the end of a sweep, at least [m]. The finger lags
/// behind the mocap body by much less, so that all readings begin and end at 0.
constexpr double kEdgeGap = 0.001;

/// Distances of the lowest point from the edge at the start and at the end.
dvec2 sweep_reach(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario) {
  const dvec2 asked(scenario.before, scenario.past);
  if (scenario.shape != ObjectShape::edge) return asked;
  const Pose X = place_finger(skin, finger_orientation(frame, scenario.tilt_deg), dvec3(0));
  return glm::max(asked, clear_reach(skin, X, scenario.depth, height_of_round(scenario.edge_radius)) + kEdgeGap);
}

/// Straight along +x, as fast as the rows want it.
void make_sweep(Motion& motion, const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario,
                const Aabb& object) {
  const double steps_per_metre = whole(1.0 / (scenario.speed * scenario.timestep));
  const dvec2 reach = sweep_reach(skin, frame, scenario);
  const double distance = reach[0] + reach[1];
  motion.X_start =
      place_finger(skin, finger_orientation(frame, scenario.tilt_deg), {-reach[0], 0, object.hi.z - scenario.depth});
  motion.steps_per_row = whole(scenario.record_every * steps_per_metre);
  motion.last_step = last_step_of(distance * steps_per_metre);
  motion.travel = [distance, steps_per_metre](std::uint64_t step) {
    return std::min(distance, static_cast<double>(step) / steps_per_metre);
  };
  motion.pose = [X = motion.X_start, travel = motion.travel](std::uint64_t step) {
    return Pose{X.q, X.p + travel(step) * dvec3(1, 0, 0)};
  };
  for (const std::uint64_t step : {std::uint64_t{0}, motion.last_step})
    motion.way_points.push_back({static_cast<double>(step) * motion.timestep, motion.pose(step)});
}

/// A part of a motion: the pose goes with u from 0 to 1 while the part lasts.
struct Part {
  double seconds = 0;
  std::function<Pose(double)> pose;
};

/// What the finger does once it is pressed down: the pose goes with u from 0 to 1; and how long that takes.
Part way_at_depth(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Pose& X_down,
                  const dvec3& lowest_W) {
  const double turn = scenario.angle_deg * kRadiansPerDegree;
  const double turning = std::abs(scenario.angle_deg) / scenario.rate_deg;
  switch (scenario.kind) {
    case ScenarioKind::roll: {
      const auto outline = std::make_shared<const RollingOutline>(skin, X_down.q);
      return {turning, [=](double u) {
                const RollingOutline::Contact contact = outline->at(u * turn);
                const dquat q = glm::angleAxis(u * turn, dvec3(0, 1, 0));
                const dvec3 rests(lowest_W.x + contact.travelled, X_down.p.y, lowest_W.z);
                return Pose{q * X_down.q, rests - q * dvec3(contact.vertex.x, 0, contact.vertex.y)};
              }};
    }
    case ScenarioKind::twist: {
      const dvec3 axis = glm::normalize(X_down.rotate(frame.pad));
      return {turning, [=](double u) {
                const dquat q = glm::angleAxis(u * turn, axis);
                return Pose{q * X_down.q, lowest_W + q * (X_down.p - lowest_W)};
              }};
    }
    case ScenarioKind::slide: {
      const double direction = scenario.direction_deg * kRadiansPerDegree;
      const dvec3 way = scenario.distance * dvec3(std::cos(direction), std::sin(direction), 0);
      return {scenario.distance / scenario.speed, [=](double u) { return Pose{X_down.q, X_down.p + u * way}; }};
    }
    default:
      return {0, [=](double) { return X_down; }};
  }
}

/// Down, the way, rest, the way back, up.
void make_pressed(Motion& motion, const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario,
                  const Aabb& object) {
  const dvec3 touch(object.center().x + scenario.place, 0, object.hi.z);
  const double drop = scenario.clearance + scenario.depth;
  motion.X_start =
      place_finger(skin, finger_orientation(frame, scenario.tilt_deg), touch + dvec3(0, 0, scenario.clearance));
  const auto lowered = [X = motion.X_start, drop](double u) { return Pose{X.q, X.p - dvec3(0, 0, u * drop)}; };
  const dvec3 lowest_W = motion.X_start * lowest_vertex(skin, motion.X_start) - dvec3(0, 0, drop);
  const Part way = way_at_depth(skin, frame, scenario, lowered(1), lowest_W);
  std::vector<Part> parts{{drop / scenario.speed, lowered},
                          way,
                          {scenario.hold, [way](double) { return way.pose(1); }},
                          {way.seconds, [way](double u) { return way.pose(1 - u); }},
                          {drop / scenario.speed, [lowered](double u) { return lowered(1 - u); }}};
  std::erase_if(parts, [](const Part& part) { return !(part.seconds > 0); });
  double end = 0;
  motion.way_points.push_back({0, motion.X_start});
  for (const Part& part : parts) motion.way_points.push_back({end += part.seconds, part.pose(1)});
  end_at(motion, scenario, end);
  motion.pose = [parts, timestep = motion.timestep](std::uint64_t step) {
    double t = static_cast<double>(step) * timestep;
    for (const Part& part : parts) {
      if (t < part.seconds) return part.pose(t / part.seconds);
      t -= part.seconds;
    }
    return parts.back().pose(1);
  };
}

void make_path(Motion& motion, const Scenario& scenario) {
  const PathCurve curve(scenario.points);
  motion.X_start = curve.at(0);
  motion.way_points = scenario.points;
  end_at(motion, scenario, curve.end());
  motion.pose = [curve, timestep = motion.timestep](std::uint64_t step) {
    return curve.at(static_cast<double>(step) * timestep);
  };
}

void make_replay(Motion& motion, const Scenario& scenario) {
  const Recording recording = read_recording(scenario.source);
  const auto poses = std::make_shared<const std::vector<Pose>>(recording.mocap);
  const auto at_rest = [](const Pose& X) { return X.p == dvec3(0) && X.q == dquat(1, 0, 0, 0); };
  if (std::all_of(poses->begin(), poses->end(), at_rest))
    throw Error(recording_file(scenario.source).string(), "mocap_pos",
                "holds no poses to replay: no mocap body moved in that run");
  motion.timestep = recording.timestep;
  motion.X_start = poses->front();
  end_at(motion, scenario, static_cast<double>(poses->size() - 1) * motion.timestep);
  motion.last_step = poses->size() - 1;
  motion.pose = [poses](std::uint64_t step) { return (*poses)[std::min<std::size_t>(step, poses->size() - 1)]; };
  // as many as a hand can still move one by one
  constexpr std::size_t kMost = 12;
  const std::size_t n = std::min(kMost, poses->size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t step = n > 1 ? i * (poses->size() - 1) / (n - 1) : 0;
    motion.way_points.push_back({static_cast<double>(step) * motion.timestep, (*poses)[step]});
  }
}

/// There and back, see paper_demo.h.
void make_paper(Motion& motion, const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario) {
  motion.X_start = place_finger(skin, demo_orientation(frame), demo_lead(0));
  end_at(motion, scenario, kDemoSeconds);
  motion.travel = [timestep = motion.timestep](std::uint64_t step) {
    return demo_travel(static_cast<double>(step) * timestep);
  };
  motion.pose = [X = motion.X_start, timestep = motion.timestep](std::uint64_t step) {
    return Pose{X.q, X.p + (demo_lead(static_cast<double>(step) * timestep) - demo_lead(0))};
  };
  for (const std::uint64_t step : {std::uint64_t{0}, motion.last_step / 2, motion.last_step})
    motion.way_points.push_back({static_cast<double>(step) * motion.timestep, motion.pose(step)});
}

}  // namespace

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
  const double half_width = crest - lowest_z + round;  // of the object, where it is widest within the finger's reach
  return {front - lowest_x + half_width, lowest_x - back + half_width};
}

Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object) {
  Motion motion;
  motion.timestep = scenario.timestep;
  switch (scenario.kind) {
    case ScenarioKind::sweep:
      make_sweep(motion, skin, frame, scenario, object);
      break;
    case ScenarioKind::drop:
      motion.X_start = place_finger(skin, finger_orientation(frame, scenario.tilt_deg),
                                    {object.center().x + scenario.place, 0, object.hi.z + scenario.height});
      end_at(motion, scenario, scenario.duration);
      break;
    case ScenarioKind::path:
      make_path(motion, scenario);
      break;
    case ScenarioKind::replay:
      make_replay(motion, scenario);
      break;
    case ScenarioKind::paper:
      make_paper(motion, skin, frame, scenario);
      break;
    default:
      make_pressed(motion, skin, frame, scenario, object);
  }
  motion.lead_M = lead_point(skin, motion.X_start);
  return motion;
}

}  // namespace taxel
