#include "core/sim/scene/sisters/sister_geoms.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/sensor/skin_cover.h"
#include "core/sim/model/drawn_mesh.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"

namespace taxel {
namespace {

Pose pose_in_body(const mjModel& m, int geom) {
  return {quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
}

}  // namespace

std::vector<Sister> sister_geoms(const mjModel& m, int geom, const SensorModel& model) {
  const int body = m.geom_bodyid[geom];
  constexpr double kLeastShare = 0.5;
  const Pose skin_in_body = pose_in_body(m, geom) * mesh_file_pose(m, geom);
  std::vector<Sister> sisters;
  for (int g = m.body_geomadr[body]; g < m.body_geomadr[body] + m.body_geomnum[body]; ++g) {
    if (g == geom || !can_collide(m, g)) continue;
    const TriMeshPtr surface = drawn_mesh(m, g);
    if (surface == nullptr) continue;
    const RigidTransform X_skin((skin_in_body.inverse() * pose_in_body(m, g)));
    const double share = share_within_skin(*surface, X_skin, *model.skin, model.layout.material.thickness);
    if (share >= kLeastShare) sisters.push_back({g, share});
  }
  return sisters;
}

int mesh_geom_of_body(const mjModel& m, const std::string& body, const std::string& file) {
  const int id = mj_name2id(&m, mjOBJ_BODY, body.c_str());
  if (id < 0) throw Error(file, fmt::format("has no body \"{}\"", body));
  int found = -1;
  for (int g = m.body_geomadr[id]; g < m.body_geomadr[id] + m.body_geomnum[id]; ++g) {
    if (m.geom_type[g] != mjGEOM_MESH) continue;
    if (found >= 0 && m.geom_dataid[found] != m.geom_dataid[g])
      throw Error(file, fmt::format("body \"{}\" has the meshes of \"{}\" and \"{}\": choose one with --geom", body,
                                    geom_name(m, found), geom_name(m, g)));
    if (found < 0) found = g;
  }
  if (found < 0) throw Error(file, fmt::format("body \"{}\" has no geom with a mesh", body));
  return found;
}

}  // namespace taxel
