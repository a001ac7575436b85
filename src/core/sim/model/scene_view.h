// A MuJoCo model and its data as the plain values of core/run: the controls and their changes, the drag of a body, and
// the geoms, sites, cameras, joints and figures that viewers show.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <span>
#include <vector>

#include "core/run/controls.h"
#include "core/run/frame.h"
#include "core/run/scene.h"

namespace taxel {

SceneControls scene_controls(const mjModel& m);

/// Returns the values in a saved state (mjSTATE_INTEGRATION), or in `d`.
ControlValues control_values(const mjModel& m, std::span<const mjtNum> integration);
ControlValues control_values(const mjModel& m, const mjData& d);

// The functions below ignore indices that the model does not have and values that are not finite, and clamp controls
// to their range. They return true if geoms may have moved.
bool set_control(const mjModel& m, mjData& d, const SetControl& edit);
bool set_joint(const mjModel& m, mjData& d, const SetJoint& edit);
bool set_mocap(const mjModel& m, mjData& d, const SetMocap& edit);
bool set_equality(const mjModel& m, mjData& d, const SetEquality& edit);
bool set_body(const mjModel& m, mjData& d, const SetBody& edit);

/// Returns the points of active connect and weld constraints, in the state that was evaluated last.
std::vector<ConstraintPoints> constraint_points(const mjModel& m, const mjData& d);

/// State of dragging one body, or of dragging none: MuJoCo's own perturbation, mjvPerturb, set from Perturb values.
class Perturbation {
 public:
  /// Sets the requested position of the grabbed body. `body` and `point_B` are the model's values for request.geom and
  /// request.point_G. A mocap body moves at once, and a free body does so while the simulation is paused. A body that
  /// is fixed to the world does not move. Returns true if geoms may have moved.
  bool follow(const mjModel& m, mjData& d, const Perturb& request, int body, const dvec3& point_B);
  void end() { *this = {}; }

  /// Adds the force of a spring and a damper to xfrc_applied, for the next step.
  void add_force(const mjModel& m, mjData& d) const;
  /// Clears the force after the step, so that no saved state has it.
  void clear_force(mjData& d) const;

  /// Returns the dragged body, or an empty value if there is none.
  [[nodiscard]] std::optional<PerturbShown> shown(const mjModel& m, const mjData& d) const;

 private:
  void grab(const mjModel& m, mjData& d, int body, const dvec3& point_B);

  Perturb request_;
  mjvPerturb start_{}, now_{};  // at the grab, and as requested now
};

/// Returns the geoms that are not fully transparent, in model order. Sets `geoms` to their numbers in the model.
std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms);

/// Returns the sites that are not fully transparent, and all cameras and joints, in model order.
SceneMarks scene_marks(const mjModel& m);
/// Sets the poses in the state that was evaluated last. Reuses the memory of `poses`.
void pose_marks(const mjModel& m, const mjData& d, MarkPoses& poses);
/// Returns the figures of the latest step.
StepFacts step_facts(const mjModel& m, const mjData& d);

}  // namespace taxel
