// How a scenario leads the finger: where its mocap body is in which step, and which steps are recorded.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Pure and without state: any step can be asked for at any time.
struct Motion {
  Pose X_start;  ///< of the finger's mesh-file frame before the first step, world
  /// X_WM of the mocap body in a step; empty: there is none, nothing leads the finger (a drop).
  std::function<Pose(std::uint64_t)> pose;
  /// What a recording calls travel [m]; empty: the mocap body's distance from its start.
  std::function<double(std::uint64_t)> travel;
  double timestep = 0;  ///< [s]
  double steps_per_row = 1;
  std::uint64_t last_step = 0;
  dvec3 lead_M{0};                   ///< the finger's lowest point at the start: its way is what is drawn
  std::vector<WayPoint> way_points;  ///< where its parts meet: passed by a path, it does much the same

  /// Rows that are due up to and including this step, less one.
  [[nodiscard]] double rows(std::uint64_t step) const;
  [[nodiscard]] bool row_due(std::uint64_t step) const;
};

/// R_WM: `distal` forward (+x) and down by the tilt, `pad` down and back.
dquat finger_orientation(const SensorFrame& frame, double tilt_deg);

/// Where the finger's frame must be for its lowest point to be at `place`, the middle of its width at that point's y.
Pose place_finger(const TriMesh& skin, const dquat& q_WM, const dvec3& place);

/// How far the lowest point of a finger at `X_WM` must be from an upright edge, before and past it along +x, for the
/// whole finger to be clear of the object. The edge is the line x = 0 at height `crest`; the object lies below the two
/// planes that descend from there by 45 degrees, each raised by at most `round`.
dvec2 clear_reach(const TriMesh& skin, const Pose& X_WM, double crest, double round);

/// `object`: its bounds in the world. Throws Error for a recording that cannot be read, or has no poses to replay.
Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object);

}  // namespace taxel
