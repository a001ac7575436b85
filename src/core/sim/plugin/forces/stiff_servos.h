// Servos whose damping MuJoCo integrates implicitly, and that are so stiff that contact forces must know it.
#pragma once

#include <mujoco/mujoco.h>

#include <span>
#include <string>
#include <vector>

namespace taxel {

/// Returns true if contact forces take the damping of servos into account: the integrator is implicit, implicitfast or
/// discrete, and a servo on a joint has h kv/m > 100, where kv is its velocity gain at the joint and m the inertia of
/// the joint at the initial pose. With weaker servos the force of the previous step is good enough.
bool has_stiff_servos(const mjModel& m);

/// Returns a sentence for each servo with h kv/m > 100 that StiffServos cannot follow, since a plugin computes its
/// force and may be called only once in a step.
std::vector<std::string> stiff_servo_warnings(const mjModel& m);

/// The inertia of a step with the damping of servos, M + h E K E^T as MuJoCo's implicit integrators have it: E has a
/// column of zeros and a 1 for the degree of freedom of each servo, K its velocity gain. A servo whose force is clamped
/// has no damping.
class StiffServos {
 public:
  /// Takes the present state. With stiff servos it computes the forces of all actuators, in qfrc_actuator, as MuJoCo
  /// does later in the step. M must be factored.
  void set(const mjModel& m, mjData& d);
  /// True if the last set() found stiff servos: then qfrc_actuator has the forces of this step.
  [[nodiscard]] bool active() const { return active_; }
  /// Solves (M + h E K E^T) x = y for n vectors of nv numbers, by the formula of Woodbury (1950). Solves M x = y
  /// without stiff servos.
  void solve(const mjModel& m, mjData& d, mjtNum* x, const mjtNum* y, int n);

 private:
  bool active_ = false;
  std::vector<std::size_t> dofs_;    // of the servos
  std::vector<mjtNum> columns_;      // M^-1 E, one row of nv numbers for each servo
  std::vector<mjtNum> capacitance_;  // Cholesky factor L of (h K)^-1 + E^T M^-1 E, row by row
  std::vector<mjtNum> part_;
};

}  // namespace taxel
