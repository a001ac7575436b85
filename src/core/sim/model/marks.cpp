#include "core/sim/model/marks.h"

#include <algorithm>

#include "core/sim/model/drawn_mesh.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"

namespace taxel {
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
    const float* rgba = material >= 0 ? m.mat_rgba + 4 * material : m.site_rgba + 4 * s;
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
