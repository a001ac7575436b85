// A body in the hand: MuJoCo's own perturbation, mjvPerturb, led by Perturb values.
#pragma once

#include <mujoco/mujoco.h>

#include <optional>

#include "core/run/controls.h"

namespace taxel {

class Perturbation {
 public:
  /// Follows the hand; `body` and `point_B` are what its geom and point are in the model. Where nothing runs, a free
  /// body goes with it at once, and so does a mocap body: returns whether geoms may lie elsewhere now. What is fixed
  /// to the world stays.
  bool follow(const mjModel& m, mjData& d, const Perturb& hand, int body, const dvec3& point_B);
  void let_go() { *this = {}; }

  /// Spring and damper to the hand, in xfrc_applied, for the step to come; then release() takes them away again, so
  /// that no saved state has them.
  void push(const mjModel& m, mjData& d) const;
  void release(mjData& d) const;

  [[nodiscard]] std::optional<PerturbShown> shown(const mjModel& m, const mjData& d) const;

 private:
  void take_hold(const mjModel& m, mjData& d, int body, const dvec3& point_B);

  Perturb hand_;
  mjvPerturb start_{}, now_{};  // as it was taken hold of, and as the hand has it
};

}  // namespace taxel
