#include "core/sim/scene/sisters/sister_geoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/sim/model/drawn_mesh.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"

namespace taxel {
namespace {

Pose pose_in_body(const mjModel& m, int geom) {
  return {quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
}

/// Returns the share of the area of a surface that is at most `reach` outside of the skin. Triangles count by small
/// parts of equal area.
double share_within(const TriMesh& surface, const RigidTransform& X_skin, const MeshIndex& skin, double reach) {
  const double part = 0.05 * surface.bounds().diagonal();  // largest edge of a part [m]
  double within = 0, all = 0;
  for (int f = 0; f < surface.face_count(); ++f) {
    const dvec3 a = surface.vertex(f, 0), u = surface.vertex(f, 1) - a, v = surface.vertex(f, 2) - a;
    const double longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
    const int n = std::max(1, static_cast<int>(std::ceil(longest / part)));
    int inside = 0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // upward triangles at even j, downward ones at odd j
        const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
        const dvec3 middle = a + (i + third) / n * u + (j / 2 + third) / n * v;
        inside += skin.signed_distance(X_skin(middle)) <= reach ? 1 : 0;
      }
    }
    const double area = 0.5 * glm::length(glm::cross(u, v));
    within += area * inside / (static_cast<double>(n) * n);
    all += area;
  }
  return all > 0 ? within / all : 0;
}

}  // namespace

std::vector<Sister> sister_geoms(const mjModel& m, int geom, const SensorModel& model) {
  const int body = m.geom_bodyid[geom];
  constexpr double kLeastShare = 0.5;
  const Pose skin_in_body = pose_in_body(m, geom) * mesh_file_pose(m, geom);
  constexpr double kMargin = 0.02;  // of the skin's diagonal: simple geoms and meshes of few faces differ a little
  const double reach = std::max(model.layout.material.thickness, kMargin * model.skin->mesh().bounds().diagonal());
  std::vector<Sister> sisters;
  for (int g = m.body_geomadr[body]; g < m.body_geomadr[body] + m.body_geomnum[body]; ++g) {
    if (g == geom || !can_collide(m, g)) continue;
    const TriMeshPtr surface = drawn_mesh(m, g);
    if (surface == nullptr) continue;
    const RigidTransform X_skin((skin_in_body.inverse() * pose_in_body(m, g)));
    const double share = share_within(*surface, X_skin, *model.skin, reach);
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
