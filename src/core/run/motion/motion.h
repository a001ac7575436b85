// The motion of a scenario: the pose of the mocap body in each step, and the steps that are recorded.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/document/scenario/scenario.h"
#include "core/layout/layout.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A motion without state: it gives the pose of any step at any time.
struct Motion {
  Pose X_start;  ///< pose of the finger's mesh-file frame before the first step, world
  /// X_WM of the mocap body in a step. Empty if nothing leads the finger (a drop).
  std::function<Pose(std::uint64_t)> pose;
  /// Travel in a recording [m]. If empty, the travel is the distance of the mocap body from its start.
  std::function<double(std::uint64_t)> travel;
  double timestep = 0;  ///< [s]
  double steps_per_row = 1;
  std::uint64_t last_step = 0;
  dvec3 lead_M{0};                   ///< lead_point() at the start; its path is drawn
  std::vector<WayPoint> way_points;  ///< ends of the parts; a path through them is similar

  /// Returns the number of rows up to and including this step, minus one.
  [[nodiscard]] double rows(std::uint64_t step) const;
  [[nodiscard]] bool row_due(std::uint64_t step) const;
};

/// Returns R_WM with `distal` forward (+x) and below the horizontal by the tilt, and `pad` down and back.
dquat finger_orientation(const SensorFrame& frame, double tilt_deg);

/// Returns the vertex that is lowest in the world, frame M.
dvec3 lowest_vertex(const TriMesh& skin, const Pose& X_WM);

/// Returns the point of the finger in the middle of its width, with the world x and z of its lowest vertex, frame M.
dvec3 lead_point(const TriMesh& skin, const Pose& X_WM);

/// Returns the pose X_WM with the orientation `q_WM` at which lead_point() is at `place`.
Pose place_finger(const TriMesh& skin, const dquat& q_WM, const dvec3& place);

/// Returns the distances of the lowest point of a finger at `X_WM` from an upright edge, before and past the edge along
/// +x, at which the whole finger is clear of the object [m]. The edge is the line x = 0 at height `crest`. The object
/// is below the two planes that descend from the edge by 45 degrees, each raised by at most `round`.
dvec2 clear_reach(const TriMesh& skin, const Pose& X_WM, double crest, double round);

/// Returns the motion of a scenario. `object` is the bounds of the object in the world. Throws Error for a recording
/// that is not readable or has no poses, and for a scenario with too many steps.
Motion make_motion(const TriMesh& skin, const SensorFrame& frame, const Scenario& scenario, const Aabb& object);

}  // namespace taxel
