#include "core/sim/model/controls.h"

#include <algorithm>
#include <cmath>

#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"

namespace taxel {
namespace {

std::optional<ControlRange> range_of(bool limited, const mjtNum* range) {
  return limited ? std::optional(ControlRange{range[0], range[1]}) : std::nullopt;
}

bool has_one_coordinate(const mjModel& m, int joint) {
  return m.jnt_type[joint] == mjJNT_HINGE || m.jnt_type[joint] == mjJNT_SLIDE;
}

/// Joints that SceneControls::joints lists.
std::vector<int> listed_joints(const mjModel& m) {
  std::vector<int> joints;
  for (int j = 0; j < m.njnt; ++j)
    if (has_one_coordinate(m, j)) joints.push_back(j);
  return joints;
}

std::vector<int> mocap_bodies(const mjModel& m) {
  std::vector<int> bodies(static_cast<std::size_t>(m.nmocap));
  for (int b = 0; b < m.nbody; ++b)
    if (m.body_mocapid[b] >= 0) bodies[static_cast<std::size_t>(m.body_mocapid[b])] = b;
  return bodies;
}

const char* equality_kind(int type) {
  switch (type) {
    case mjEQ_CONNECT:
      return "connect";
    case mjEQ_WELD:
      return "weld";
    case mjEQ_JOINT:
      return "joint";
    case mjEQ_TENDON:
      return "tendon";
    default:
      return "flex";
  }
}

const char* integrator_word(int integrator) {
  switch (integrator) {
    case mjINT_EULER:
      return "Euler";
    case mjINT_RK4:
      return "RK4";
    case mjINT_IMPLICIT:
      return "implicit";
    default:
      return "implicitfast";
  }
}

bool holds_points(const mjModel& m, int equality) {
  return m.eq_type[equality] == mjEQ_CONNECT || m.eq_type[equality] == mjEQ_WELD;
}

/// One part of a saved state.
std::vector<mjtNum> part(const mjModel& m, std::span<const mjtNum> integration, int what) {
  std::vector<mjtNum> values(static_cast<std::size_t>(mj_stateSize(&m, what)));
  mj_extractState(&m, integration.data(), mjSTATE_INTEGRATION, values.data(), what);
  return values;
}

ControlValues values_of(const mjModel& m, std::span<const mjtNum> controls, std::span<const mjtNum> positions,
                        std::span<const mjtNum> mocap_positions, std::span<const mjtNum> mocap_turns) {
  ControlValues values;
  values.controls.assign(controls.begin(), controls.end());
  for (const int j : listed_joints(m)) values.joints.push_back(positions[static_cast<std::size_t>(m.jnt_qposadr[j])]);
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.nmocap); ++i)
    values.mocaps.push_back({quat(mocap_turns.data() + 4 * i), vec3(mocap_positions.data() + 3 * i)});
  return values;
}

std::span<const mjtNum> span_of(const mjtNum* values, mjtSize count) {
  return {values, static_cast<std::size_t>(count)};
}

bool in_list(int index, mjtSize count) {
  return index >= 0 && index < count;
}

/// Anchor of a connect or weld constraint on one of its two sides: the sites where it names some; else a point of each
/// body's frame in eq_data, the first body's first for connect, the second's first for weld.
dvec3 anchor(const mjModel& m, const mjData& d, int equality, int side) {
  const int id = side == 0 ? m.eq_obj1id[equality] : m.eq_obj2id[equality];
  if (m.eq_objtype[equality] == mjOBJ_SITE) return vec3(d.site_xpos + 3 * id);
  const mjtNum* data = m.eq_data + mjNEQDATA * equality;
  const bool connect = m.eq_type[equality] == mjEQ_CONNECT;
  return body_pose(d, id) * vec3(data + 3 * (connect ? side : 1 - side));
}

}  // namespace

SceneControls scene_controls(const mjModel& m) {
  SceneControls controls;
  for (int b = 0; b < m.nbody; ++b)
    controls.bodies.push_back(
        {body_name(m, b), m.body_mocapid[b], m.body_weldid[b] == 0 && m.body_mocapid[b] < 0, m.body_parentid[b]});
  for (int a = 0; a < m.nu; ++a)
    controls.actuators.push_back({object_name(m, mjOBJ_ACTUATOR, a, "actuator"),
                                  range_of(m.actuator_ctrllimited[a] != 0, m.actuator_ctrlrange + 2 * a)});
  for (const int j : listed_joints(m))
    controls.joints.push_back({object_name(m, mjOBJ_JOINT, j, "joint"), m.jnt_type[j] == mjJNT_HINGE,
                               range_of(m.jnt_limited[j] != 0, m.jnt_range + 2 * j)});
  for (int k = 0; k < m.nkey; ++k)
    controls.keyframes.push_back({object_name(m, mjOBJ_KEY, k, "keyframe"), m.key_time[k]});
  for (const int body : mocap_bodies(m)) controls.mocaps.push_back(body_name(m, body));
  for (int e = 0; e < m.neq; ++e)
    controls.equalities.push_back(
        {object_name(m, mjOBJ_EQUALITY, e, "equality"), equality_kind(m.eq_type[e]), holds_points(m, e)});
  controls.gravity = vec3(m.opt.gravity);
  controls.integrator = integrator_word(m.opt.integrator);
  return controls;
}

ControlValues control_values(const mjModel& m, std::span<const mjtNum> integration) {
  ControlValues values = values_of(m, part(m, integration, mjSTATE_CTRL), part(m, integration, mjSTATE_QPOS),
                                   part(m, integration, mjSTATE_MOCAP_POS), part(m, integration, mjSTATE_MOCAP_QUAT));
  for (const mjtNum active : part(m, integration, mjSTATE_EQ_ACTIVE)) values.equalities.push_back(active != 0);
  return values;
}

ControlValues control_values(const mjModel& m, const mjData& d) {
  ControlValues values = values_of(m, span_of(d.ctrl, m.nu), span_of(d.qpos, m.nq), span_of(d.mocap_pos, 3 * m.nmocap),
                                   span_of(d.mocap_quat, 4 * m.nmocap));
  values.equalities.assign(d.eq_active, d.eq_active + m.neq);
  return values;
}

bool set_control(const mjModel& m, mjData& d, const SetControl& edit) {
  if (!in_list(edit.actuator, m.nu) || !std::isfinite(edit.value)) return false;
  const mjtNum* range = m.actuator_ctrlrange + 2 * edit.actuator;
  const bool limited = m.actuator_ctrllimited[edit.actuator] != 0;
  d.ctrl[edit.actuator] = limited ? std::clamp(edit.value, range[0], range[1]) : edit.value;
  return false;
}

bool set_joint(const mjModel& m, mjData& d, const SetJoint& edit) {
  const std::vector<int> joints = listed_joints(m);
  if (!in_list(edit.joint, static_cast<mjtSize>(joints.size())) || !std::isfinite(edit.value)) return false;
  const int joint = joints[static_cast<std::size_t>(edit.joint)];
  d.qpos[m.jnt_qposadr[joint]] = edit.value;
  d.qvel[m.jnt_dofadr[joint]] = 0;  // it was put there, not thrown
  return true;
}

bool set_mocap(const mjModel& m, mjData& d, const SetMocap& edit) {
  const double length = glm::length(edit.X_WB.q);
  if (!in_list(edit.mocap, m.nmocap) || !is_finite(edit.X_WB.p) || !std::isfinite(length) || length == 0) return false;
  const dquat q = edit.X_WB.q / length;
  put(d.mocap_pos + 3 * edit.mocap, edit.X_WB.p);
  put(d.mocap_quat + 4 * edit.mocap, q);
  return true;
}

bool set_equality(const mjModel& m, mjData& d, const SetEquality& edit) {
  if (!in_list(edit.equality, m.neq)) return false;
  d.eq_active[edit.equality] = edit.active;
  return true;
}

std::vector<ConstraintPoints> constraint_points(const mjModel& m, const mjData& d) {
  std::vector<ConstraintPoints> points;
  for (int e = 0; e < m.neq; ++e)
    if (d.eq_active[e] != 0 && holds_points(m, e))
      points.push_back({anchor(m, d, e, 0), anchor(m, d, e, 1), m.eq_type[e] == mjEQ_WELD});
  return points;
}

}  // namespace taxel
