// The inertia of a step with the damping of stiff servos.
//
// Under its implicit integrators MuJoCo divides the force of a servo by 1 + h kv/m within the step. A contact that
// knows only M would take h kv/m times the velocity of a servo that starts. So M + h E K E^T takes the place of M, with
// one column of E per servo. By the formula of Woodbury (1950) a solution with it is one with M and a correction by a
// small matrix, one row per servo, whose Cholesky factor is made once per step.
//
// The forces of the actuators must then be those of this step: mj_fwdActuation() is called early, as it reads nothing
// that MuJoCo computes later, and MuJoCo calls it again. Models whose actuators are computed by plugins are left out,
// since a plugin may count its calls. Models with h kv/m up to 100 keep their bits. Theory: docs/theory/sim.md, "The
// implicit step".
#include "core/sim/plugin/forces/stiff_servos.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

constexpr double kMostDamping = 100;  // largest h kv/m at which the actuator forces of the previous step are taken

/// Returns the number of actuators. From MuJoCo 3.17 on an actuator may have several controls and several outputs.
template <class Model>
int actuator_count(const Model& m) {
  if constexpr (requires { m.nactuator; }) return static_cast<int>(m.nactuator);
  return static_cast<int>(m.nu);
}
template <class Model>
int first_output(const Model& m, int actuator) {
  if constexpr (requires { m.actuator_outadr; }) return m.actuator_outadr[actuator];
  return actuator;
}

/// Returns true for implicit, implicitfast and, from MuJoCo 3.17 on, discrete, the integrators after Runge and Kutta's.
bool is_implicit(const mjModel& m) {
  return m.opt.integrator >= mjINT_IMPLICIT;
}

/// A servo on a hinge or a slide.
struct Servo {
  int actuator = 0, joint = 0;
  double damping = 0;  ///< velocity gain at the joint
};

template <class Action>
void for_each_servo(const mjModel& m, const Action& action) {
  const int count = actuator_count(m);
  for (int i = 0; i < count; ++i) {
    if (m.actuator_trntype[i] != mjTRN_JOINT && m.actuator_trntype[i] != mjTRN_JOINTINPARENT) continue;
    if (m.actuator_biastype[i] != mjBIAS_AFFINE) continue;
    const int joint = m.actuator_trnid[2 * i];
    if (m.jnt_type[joint] != mjJNT_HINGE && m.jnt_type[joint] != mjJNT_SLIDE) continue;
    const double gear = m.actuator_gear[6 * first_output(m, i)];
    const double damping = -m.actuator_biasprm[mjNBIAS * i + 2] * gear * gear;
    if (damping > 0) action(Servo{i, joint, damping});
  }
}

double ratio_of(const mjModel& m, const Servo& servo) {
  return m.opt.timestep * servo.damping / m.dof_M0[m.jnt_dofadr[servo.joint]];
}

bool any_computed_by_plugin(const mjModel& m) {
  return std::any_of(m.actuator_plugin, m.actuator_plugin + actuator_count(m), [](int plugin) { return plugin >= 0; });
}

bool is_disabled(const mjModel& m, int actuator) {
  const int group = m.actuator_group[actuator];
  return (m.opt.disableflags & mjDSBL_ACTUATION) != 0 ||
         (group >= 0 && group < 31 && (m.opt.disableactuator & (1 << group)) != 0);
}

bool is_clamped(const mjModel& m, const mjData& d, int actuator) {
  if (!m.actuator_forcelimited[actuator]) return false;
  const mjtNum force = d.actuator_force[first_output(m, actuator)];
  return force <= m.actuator_forcerange[2 * actuator] || force >= m.actuator_forcerange[2 * actuator + 1];
}

/// Computes the Cholesky factor of an n x n matrix in its lower triangle.
void factor(std::vector<mjtNum>& A, std::size_t n) {
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      mjtNum sum = A[r * n + c];
      for (std::size_t k = 0; k < c; ++k) sum -= A[r * n + k] * A[c * n + k];
      A[r * n + c] = r == c ? std::sqrt(sum) : sum / A[c * n + c];
    }
  }
}

/// Solves L L^T x = b in place.
void solve_factored(const std::vector<mjtNum>& L, std::vector<mjtNum>& b) {
  const std::size_t n = b.size();
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t k = 0; k < r; ++k) b[r] -= L[r * n + k] * b[k];
    b[r] /= L[r * n + r];
  }
  for (std::size_t r = n; r-- > 0;) {
    for (std::size_t k = r + 1; k < n; ++k) b[r] -= L[k * n + r] * b[k];
    b[r] /= L[r * n + r];
  }
}

}  // namespace

bool has_stiff_servos(const mjModel& m) {
  if (!is_implicit(m)) return false;
  bool stiff = false;
  for_each_servo(m, [&](const Servo& servo) { stiff = stiff || ratio_of(m, servo) > kMostDamping; });
  return stiff && !any_computed_by_plugin(m);
}

std::vector<std::string> stiff_servo_warnings(const mjModel& m) {
  std::vector<std::string> warnings;
  if (!is_implicit(m) || !any_computed_by_plugin(m)) return warnings;
  for_each_servo(m, [&](const Servo& servo) {
    if (!(ratio_of(m, servo) > kMostDamping)) return;
    warnings.push_back(
        fmt::format("the damping of actuator \"{}\" is too stiff for contact forces under this integrator while a "
                    "plugin computes an "
                    "actuator: timestep x kv / inertia of joint \"{}\" is {:.4g}, and above {} friction and damping of "
                    "a contact are "
                    "wrong when the servo starts or stops. A smaller kv, more armature or a smaller timestep helps",
                    m.names + m.name_actuatoradr[servo.actuator], m.names + m.name_jntadr[servo.joint],
                    ratio_of(m, servo), kMostDamping));
  });
  return warnings;
}

void StiffServos::set(const mjModel& m, mjData& d) {
  active_ = has_stiff_servos(m);
  dofs_.clear();
  if (!active_) return;
  mj_fwdActuation(&m, &d);
  std::vector<double> inverse;  // of h kv
  for_each_servo(m, [&](const Servo& servo) {
    if (is_disabled(m, servo.actuator) || is_clamped(m, d, servo.actuator)) return;
    const auto dof = static_cast<std::size_t>(m.jnt_dofadr[servo.joint]);
    dofs_.push_back(dof);
    inverse.push_back(1 / (m.opt.timestep * servo.damping));
  });
  const std::size_t count = dofs_.size(), nv = static_cast<std::size_t>(m.nv);
  if (count == 0) return;
  part_.assign(count * nv, 0);
  for (std::size_t k = 0; k < count; ++k) part_[k * nv + dofs_[k]] = 1;
  columns_.resize(count * nv);
  mj_solveM(&m, &d, columns_.data(), part_.data(), static_cast<int>(count));
  capacitance_.resize(count * count);
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t c = 0; c < count; ++c)
      capacitance_[r * count + c] = columns_[c * nv + dofs_[r]] + (r == c ? inverse[r] : 0);
  factor(capacitance_, count);
}

void StiffServos::solve(const mjModel& m, mjData& d, mjtNum* x, const mjtNum* y, int n) {
  mj_solveM(&m, &d, x, y, n);
  const std::size_t nv = static_cast<std::size_t>(m.nv);
  if (dofs_.empty()) return;
  for (int i = 0; i < n; ++i, x += nv) {
    part_.resize(dofs_.size());
    for (std::size_t k = 0; k < dofs_.size(); ++k) part_[k] = x[dofs_[k]];
    solve_factored(capacitance_, part_);
    for (std::size_t k = 0; k < dofs_.size(); ++k)
      for (std::size_t j = 0; j < nv; ++j) x[j] -= part_[k] * columns_[k * nv + j];
  }
}

}  // namespace taxel
