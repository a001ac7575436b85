#include "core/sim/model/sdf_mesh.h"

#include <fmt/format.h>

#include <vector>

#include "core/base/error.h"
#include "core/mesh/make/level_set.h"

namespace taxel {
namespace {

/// Returns the plugin's attributes in the form that its functions take. The plugin converts the configuration itself.
std::vector<mjtNum> attributes_of(const mjModel& m, const mjpPlugin& plugin, int instance) {
  std::vector<const char*> names, values;
  for (int i = 0; i < plugin.nattribute; ++i) {
    names.push_back(plugin.attributes[i]);
    const char* value = mj_getPluginConfig(&m, instance, plugin.attributes[i]);
    values.push_back(value != nullptr ? value : "");
  }
  std::vector<mjtNum> numbers(static_cast<std::size_t>(plugin.nattribute) + 1, 0.0);  // never empty
  plugin.sdf_attribute(numbers.data(), names.data(), values.data());
  return numbers;
}

}  // namespace

TriMesh sdf_mesh(const mjModel& m, int geom, double edge) {
  const int instance = m.geom_plugin[geom], mesh = m.geom_dataid[geom];
  const mjpPlugin* plugin = mjp_getPluginAtSlot(m.plugin[instance]);
  if (plugin == nullptr || plugin->sdf_staticdistance == nullptr || plugin->sdf_attribute == nullptr ||
      plugin->sdf_aabb == nullptr)
    throw Error(fmt::format("plugin \"{}\" has no sdf_staticdistance, sdf_attribute and sdf_aabb",
                            plugin != nullptr ? plugin->name : "?"));
  const std::vector<mjtNum> attributes = attributes_of(m, *plugin, instance);
  mjtNum center_and_half[6];
  plugin->sdf_aabb(center_and_half, attributes.data());
  const dvec3 center(center_and_half[0], center_and_half[1], center_and_half[2]);
  const dvec3 half(center_and_half[3], center_and_half[4], center_and_half[5]);
  const Aabb box{center - half, center + half};
  constexpr double kDefaultCells = 40;
  if (!(edge > 0)) edge = 2 * std::max({half.x, half.y, half.z}) / kDefaultCells;
  const TriMesh surface = make_level_set(
      [&](const dvec3& x) {
        const mjtNum point[3] = {x.x, x.y, x.z};
        return static_cast<double>(plugin->sdf_staticdistance(point, attributes.data()));
      },
      box, edge);
  if (surface.face_count() == 0) throw Error("its distance function is negative nowhere in its bounding box");
  if (mesh < 0) return surface;
  // The function is in the frame of the mesh before MuJoCo moved the mesh to the geom's frame.
  const mjtNum *p = m.mesh_pos + 3 * mesh, *q = m.mesh_quat + 4 * mesh;
  const RigidTransform X_GF(Pose{dquat(q[0], q[1], q[2], q[3]), dvec3(p[0], p[1], p[2])}.inverse());
  std::vector<dvec3> vertices;
  for (const dvec3& v : surface.vertices()) vertices.push_back(X_GF(v));
  return {std::move(vertices), surface.faces()};
}

}  // namespace taxel
