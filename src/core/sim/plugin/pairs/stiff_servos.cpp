#include "core/sim/plugin/pairs/stiff_servos.h"

#include <fmt/format.h>

namespace taxel {
namespace {

constexpr double kMostDamping = 100;  // largest h kv/m without a warning

}  // namespace

std::vector<std::string> stiff_servo_warnings(const mjModel& m) {
  std::vector<std::string> warnings;
  if (m.opt.integrator != mjINT_IMPLICIT && m.opt.integrator != mjINT_IMPLICITFAST) return warnings;
  for (int i = 0; i < m.nu; ++i) {
    if (m.actuator_trntype[i] != mjTRN_JOINT && m.actuator_trntype[i] != mjTRN_JOINTINPARENT) continue;
    if (m.actuator_biastype[i] != mjBIAS_AFFINE) continue;
    const int joint = m.actuator_trnid[2 * i];
    if (m.jnt_type[joint] != mjJNT_HINGE && m.jnt_type[joint] != mjJNT_SLIDE) continue;
    const double gear = m.actuator_gear[6 * i], kv = -m.actuator_biasprm[mjNBIAS * i + 2] * gear * gear;
    const double inertia = m.dof_M0[m.jnt_dofadr[joint]], ratio = m.opt.timestep * kv / inertia;
    if (!(ratio > kMostDamping)) continue;
    warnings.push_back(fmt::format(
        "the damping of actuator \"{}\" is too stiff for contact forces under this integrator: timestep x kv "
        "/ inertia of joint \"{}\" is {:.4g}, and above {} friction and damping of a contact are wrong when "
        "the servo starts or stops. A smaller kv, more armature or a smaller timestep helps",
        m.names + m.name_actuatoradr[i], m.names + m.name_jntadr[joint], ratio, kMostDamping));
  }
  return warnings;
}

}  // namespace taxel
