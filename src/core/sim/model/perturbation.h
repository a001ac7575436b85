// A body that the user drags: MuJoCo's own perturbation, mjvPerturb, set from Perturb values.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>

#include "core/run/controls.h"

namespace taxel {

/// State of dragging one body, or of dragging none.
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

}  // namespace taxel
