#include "core/sim/model/scene_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mesh/mesh_io.h"
#include "core/sim/model/geometry.h"

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

/// Returns the free joint of a body, or -1.
int free_joint(const mjModel& m, int body) {
  const int joint = m.body_jntnum[body] == 1 ? m.body_jntadr[body] : -1;
  return joint >= 0 && m.jnt_type[joint] == mjJNT_FREE ? joint : -1;
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
    controls.bodies.push_back({body_name(m, b), m.body_mocapid[b], m.body_weldid[b] == 0 && m.body_mocapid[b] < 0,
                               m.body_parentid[b], free_joint(m, b) >= 0});
  for (int a = 0; a < m.nu; ++a) {
    const bool drives_joint = m.actuator_trntype[a] == mjTRN_JOINT || m.actuator_trntype[a] == mjTRN_JOINTINPARENT;
    controls.actuators.push_back({object_name(m, mjOBJ_ACTUATOR, a, "actuator"),
                                  range_of(m.actuator_ctrllimited[a] != 0, m.actuator_ctrlrange + 2 * a),
                                  drives_joint ? object_name(m, mjOBJ_JOINT, m.actuator_trnid[2 * a], "joint") : ""});
  }
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

bool set_body(const mjModel& m, mjData& d, const SetBody& edit) {
  if (!in_list(edit.body, m.nbody) || !is_finite(edit.X_WB.p)) return false;
  if (const int mocap = m.body_mocapid[edit.body]; mocap >= 0) return set_mocap(m, d, {mocap, edit.X_WB});
  const int joint = free_joint(m, edit.body);
  if (joint < 0) return false;
  const dquat q = glm::normalize(edit.X_WB.q);
  mjtNum* place = d.qpos + m.jnt_qposadr[joint];
  put(place, edit.X_WB.p);
  put(place + 3, q);
  std::fill_n(d.qvel + m.jnt_dofadr[joint], 6, 0.0);  // it was put there, not thrown
  return true;
}

std::vector<ConstraintPoints> constraint_points(const mjModel& m, const mjData& d) {
  std::vector<ConstraintPoints> points;
  for (int e = 0; e < m.neq; ++e)
    if (d.eq_active[e] != 0 && holds_points(m, e))
      points.push_back({anchor(m, d, e, 0), anchor(m, d, e, 1), m.eq_type[e] == mjEQ_WELD});
  return points;
}

namespace {

/// Orientation of a body's inertial frame, which mjvPerturb refers to.
dquat inertial_turn(const mjModel& m, const mjData& d, int body) {
  return quat(d.xquat + 4 * body) * quat(m.body_iquat + 4 * body);
}

dvec3 grabbed_point(const mjData& d, const mjvPerturb& perturb) {
  return body_pose(d, perturb.select) * vec3(perturb.localpos);
}

/// The apparent mass at a point, 3 / trace(J M^-1 J^T), as in mjv_initPerturb; 1 if nothing can move.
double mass_at(const mjModel& m, mjData& d, int body, const dvec3& p_W) {
  if (m.nv == 0) return 1;
  std::vector<mjtNum> J(3 * static_cast<std::size_t>(m.nv)), M_inv_JT(J.size());
  mj_jac(&m, &d, J.data(), nullptr, &p_W[0], body);
  mj_solveM(&m, &d, M_inv_JT.data(), J.data(), 3);
  const mjtNum trace = mju_dot(J.data(), M_inv_JT.data(), static_cast<int>(J.size()));
  return trace == 0 ? 1 : 3 / std::max(trace, mjMINVAL);
}

}  // namespace

void Perturbation::grab(const mjModel& m, mjData& d, int body, const dvec3& point_B) {
  mjv_defaultPerturb(&start_);
  start_.select = body;
  put(start_.localpos, point_B);
  const dvec3 point_W = grabbed_point(d, start_);
  put(start_.refselpos, point_W);
  put(start_.refpos, vec3(d.xipos + 3 * body));
  put(start_.refquat, inertial_turn(m, d, body));
  start_.localmass = mass_at(m, d, body, point_W);
}

bool Perturbation::follow(const mjModel& m, mjData& d, const Perturb& request, int body, const dvec3& point_B) {
  const bool again = request_.kind == request.kind && request_.grip == request.grip && start_.select == body;
  if (!again) grab(m, d, body, point_B);
  request_ = request;
  now_ = start_;
  now_.active = request.kind == Perturb::Kind::pull ? mjPERT_TRANSLATE : mjPERT_ROTATE;
  put(now_.refselpos, vec3(start_.refselpos) + request.moved_W);
  put(now_.refpos, vec3(start_.refpos) + request.moved_W);
  put(now_.refquat, glm::normalize(request.turned_W * quat(start_.refquat)));
  if (m.body_weldid[body] == 0 && m.body_mocapid[body] < 0) return false;
  mjv_applyPerturbPose(&m, &d, &now_, request.running ? 0 : 1);
  return true;
}

void Perturbation::add_force(const mjModel& m, mjData& d) const {
  if (now_.active == 0) return;
  mjv_applyPerturbPose(&m, &d, &now_, 0);
  if (m.body_weldid[now_.select] != 0) mjv_applyPerturbForce(&m, &d, &now_);
}

void Perturbation::clear_force(mjData& d) const {
  if (now_.active != 0) std::fill_n(d.xfrc_applied + 6 * now_.select, 6, 0.0);
}

std::optional<PerturbShown> Perturbation::shown(const mjModel& m, const mjData& d) const {
  if (now_.active == 0) return std::nullopt;
  return PerturbShown{request_.kind, now_.select, grabbed_point(d, now_), vec3(now_.refselpos),
                      glm::normalize(quat(now_.refquat) * glm::conjugate(inertial_turn(m, d, now_.select)))};
}

namespace {

GeomSkin skin_of(const mjModel& m, int geom, const TriMesh& surface) {
  GeomSkin skin;
  const int type = m.geom_type[geom], mesh = type == mjGEOM_MESH ? m.geom_dataid[geom] : -1;
  if (type == mjGEOM_PLANE) skin.problem = "is a plane, which has no closed surface";
  if (type == mjGEOM_HFIELD) skin.problem = "is a height field, which can only be rigid";
  if (type == mjGEOM_SDF) skin.problem = "is a signed distance function, which can only be rigid";
  if (skin.problem.empty() && !(surface.area() > 0)) skin.problem = "has no area";
  if (mesh < 0) return skin;
  skin.X_GM = mesh_file_pose(m, geom);
  const dvec3 scale = vec3(m.mesh_scale + 3 * mesh);
  const bool is_mirrored = scale.x * scale.y * scale.z < 0;
  if (m.mesh_pathadr[mesh] < 0 || is_mirrored || !is_mesh_file(m.paths + m.mesh_pathadr[mesh])) return skin;
  skin.file = m.paths + m.mesh_pathadr[mesh];
  skin.scale = scale;
  return skin;
}

/// Returns the colour that MuJoCo draws: that of the material, unless the object has one that is not MuJoCo's default.
const float* shown_rgba(const mjModel& m, const float* own, int material) {
  const bool is_default = own[0] == 0.5f && own[1] == 0.5f && own[2] == 0.5f && own[3] == 1.0f;
  return material >= 0 && is_default ? m.mat_rgba + 4 * material : own;
}

}  // namespace

std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms) {
  std::vector<SceneGeom> drawn;
  geoms.clear();
  for (int g = 0; g < m.ngeom; ++g) {
    const int material = m.geom_matid[g];
    const float* rgba = shown_rgba(m, m.geom_rgba + 4 * g, material);
    if (!(rgba[3] > 0)) continue;
    SceneGeom geom;
    geom.name = geom_name(m, g);
    geom.body = body_name(m, m.geom_bodyid[g]);
    geom.body_index = m.geom_bodyid[g];
    if (const int mesh = m.geom_dataid[g]; m.geom_type[g] == mjGEOM_MESH && mesh >= 0)
      geom.mesh_name = m.names + m.name_meshadr[mesh];
    geom.mesh = drawn_mesh(m, g);
    if (geom.mesh == nullptr) continue;
    geom.rgba = {rgba[0], rgba[1], rgba[2], rgba[3]};
    geom.plane = m.geom_type[g] == mjGEOM_PLANE;
    geom.group = std::clamp(m.geom_group[g], 0, mjNGROUP - 1);  // clamped as in MuJoCo's viewer
    geom.skin = skin_of(m, g, *geom.mesh);
    drawn.push_back(std::move(geom));
    geoms.push_back(g);
  }
  return drawn;
}

namespace {

static_assert(kSceneGroups == mjNGROUP);

TriMeshPtr site_mesh(const mjModel& m, int site) {
  if (m.site_type[site] != mjGEOM_MESH) return drawn_primitive(m.site_type[site], vec3(m.site_size + 3 * site));
  const int mesh = m.site_dataid[site];
  return mesh < 0 ? nullptr : std::make_shared<const TriMesh>(mesh_triangles(m, mesh));
}

bool look_alike(const mjModel& m, int a, int b) {
  return m.site_type[a] == m.site_type[b] && m.site_dataid[a] == m.site_dataid[b] &&
         std::equal(m.site_size + 3 * a, m.site_size + 3 * a + 3, m.site_size + 3 * b);
}

std::vector<SceneSite> drawable_sites(const mjModel& m) {
  std::vector<SceneSite> sites;
  std::vector<int> numbers;
  for (int s = 0; s < m.nsite; ++s) {
    const int material = m.site_matid[s];
    const float* rgba = shown_rgba(m, m.site_rgba + 4 * s, material);
    if (!(rgba[3] > 0)) continue;
    SceneSite site;
    site.name = object_name(m, mjOBJ_SITE, s, "site");
    site.body = m.site_bodyid[s];
    site.X_BS = {quat(m.site_quat + 4 * s), vec3(m.site_pos + 3 * s)};
    const auto alike = std::find_if(numbers.begin(), numbers.end(), [&](int other) { return look_alike(m, other, s); });
    site.mesh =
        alike == numbers.end() ? site_mesh(m, s) : sites[static_cast<std::size_t>(alike - numbers.begin())].mesh;
    std::copy_n(rgba, 4, site.rgba.begin());
    site.group = std::clamp(m.site_group[s], 0, mjNGROUP - 1);  // clamped as in MuJoCo's viewer
    sites.push_back(std::move(site));
    numbers.push_back(s);
  }
  return sites;
}

SceneOverview scene_overview(const mjModel& m) {
  SceneOverview overview;
  overview.center_W = vec3(m.stat.center);
  overview.extent = m.stat.extent;
  // MuJoCo's angles are the direction in which the camera looks; ours are the direction from the centre to the camera.
  overview.azimuth_deg = static_cast<double>(m.vis.global.azimuth) + 180;
  overview.elevation_deg = -static_cast<double>(m.vis.global.elevation);
  if (m.vis.global.orthographic == 0) overview.fov_deg = static_cast<double>(m.vis.global.fovy);
  return overview;
}

const char* solver_word(int solver) {
  return solver == mjSOL_PGS ? "PGS" : solver == mjSOL_CG ? "CG" : "Newton";
}

}  // namespace

SceneMarks scene_marks(const mjModel& m) {
  SceneMarks marks;
  marks.sites = drawable_sites(m);
  for (int c = 0; c < m.ncam; ++c)
    marks.cameras.push_back(
        {object_name(m, mjOBJ_CAMERA, c, "camera"), m.cam_fovy[c], m.cam_projection[c] == mjPROJ_ORTHOGRAPHIC});
  for (int j = 0; j < m.njnt; ++j)
    marks.joints.push_back({object_name(m, mjOBJ_JOINT, j, "joint"), m.jnt_bodyid[j], vec3(m.jnt_pos + 3 * j)});
  marks.overview = scene_overview(m);
  marks.mean_size = m.stat.meansize;
  marks.dofs = static_cast<int>(m.nv);
  marks.arena = static_cast<std::uint64_t>(m.narena);
  marks.solver = solver_word(m.opt.solver);
  return marks;
}

void pose_marks(const mjModel& m, const mjData& d, MarkPoses& poses) {
  poses.bodies.clear();
  poses.cameras.clear();
  for (int b = 0; b < m.nbody; ++b) poses.bodies.push_back(body_pose(d, b));
  for (int c = 0; c < m.ncam; ++c) {
    mjtNum q[4];
    mju_mat2Quat(q, d.cam_xmat + 9 * c);
    poses.cameras.push_back({quat(q), vec3(d.cam_xpos + 3 * c)});
  }
}

StepFacts step_facts(const mjModel& m, const mjData& d) {
  StepFacts facts;
  facts.contacts = d.ncon;
  facts.constraints = d.nefc;
  facts.islands = d.nisland;
  for (int i = 0; i < std::clamp(d.nisland, 1, mjNISLAND); ++i) facts.iterations += d.solver_niter[i];
  facts.arena = static_cast<std::uint64_t>(d.maxuse_arena);
  if ((m.opt.enableflags & mjENBL_ENERGY) != 0) facts.energy = SceneEnergy{d.energy[0], d.energy[1]};
  return facts;
}

}  // namespace taxel
