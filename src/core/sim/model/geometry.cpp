#include "core/sim/model/geometry.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/text/geom_labels.h"
#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/make/level_set.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/tri_mesh.h"

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

/// Computes the surface of an SDF geom that has a plugin, frame G: the zero level of the plugin's distance function
/// with the geom's configuration. It is the function that MuJoCo collides with, in the form without mjData
/// (`sdf_staticdistance`), because bodies are built before a plugin has data. Marching tetrahedra run in the plugin's
/// bounding box with edges of about `edge` [m]; 0 means a fortieth of the largest extent of the box. Throws Error if
/// the plugin lacks these functions or the surface leaves the box, and as make_level_set() does.
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

}  // namespace
std::string object_name(const mjModel& m, mjtObj type, int id, const char* kind) {
  const char* name = mj_id2name(&m, type, id);
  return name != nullptr && *name != '\0' ? name : kind + std::string(" ") + std::to_string(id);
}

std::string geom_type_word(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_HFIELD:
      return "hfield";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    case mjGEOM_SDF:
      return "sdf";
    default:
      return "";
  }
}

std::string geom_name(const mjModel& m, int geom) {
  if (const char* name = mj_id2name(&m, mjOBJ_GEOM, geom); name != nullptr && *name != '\0') return name;
  std::vector<GeomParts> parts;  // of the geoms of the body
  std::size_t own = 0;
  for (int g = 0; g < m.ngeom; ++g) {
    if (m.geom_bodyid[g] != m.geom_bodyid[geom]) continue;
    if (g == geom) own = parts.size();
    const int mesh = m.geom_type[g] == mjGEOM_MESH ? m.geom_dataid[g] : -1;
    parts.push_back({g == geom ? "" : m.names + m.name_geomadr[g], body_name(m, m.geom_bodyid[g]), "",
                     mesh >= 0 ? m.names + m.name_meshadr[mesh] : "", geom_type_word(m.geom_type[g])});
  }
  return geom_labels(parts)[own];
}

std::string body_name(const mjModel& m, int body) {
  return object_name(m, mjOBJ_BODY, body, "body");
}

Pose body_pose(const mjData& d, int body) {
  return {quat(d.xquat + 4 * body), vec3(d.xpos + 3 * body)};
}

Pose geom_pose(const mjModel& m, const mjData& d, int geom) {
  const Pose X_BG{quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
  return body_pose(d, m.geom_bodyid[geom]) * X_BG;
}

Pose mesh_file_pose(const mjModel& m, int geom) {
  const int mesh = m.geom_dataid[geom];
  if (m.geom_type[geom] != mjGEOM_MESH || mesh < 0) return {};
  return Pose{quat(m.mesh_quat + 4 * mesh), vec3(m.mesh_pos + 3 * mesh)}.inverse();
}

TriMesh mesh_triangles(const mjModel& m, int mesh) {
  const float* v = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
  const int* f = m.mesh_face + 3 * m.mesh_faceadr[mesh];
  PolygonSoup soup;
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) soup.vertices.emplace_back(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
  for (int i = 0; i < m.mesh_facenum[mesh]; ++i) soup.triangles.emplace_back(f[3 * i], f[3 * i + 1], f[3 * i + 2]);
  std::vector<std::string> notes;
  return weld(soup, dvec3(1), notes);
}

TriMesh compiled_mesh(const mjModel& m, int geom) {
  return mesh_triangles(m, m.geom_dataid[geom]);
}

TriMesh height_field_mesh(const mjModel& m, int geom) {
  const int id = m.geom_dataid[geom];
  HeightField field;
  field.rows = m.hfield_nrow[id];
  field.columns = m.hfield_ncol[id];
  const float* data = m.hfield_data + m.hfield_adr[id];
  field.elevation.assign(data, data + field.rows * field.columns);
  const mjtNum* size = m.hfield_size + 4 * id;
  field.size = vec3(size);
  field.base = size[3];
  return make_height_field(field);
}

namespace {

std::optional<ShapeType> primitive_type(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return ShapeType::plane;
    case mjGEOM_SPHERE:
      return ShapeType::sphere;
    case mjGEOM_CAPSULE:
      return ShapeType::capsule;
    case mjGEOM_ELLIPSOID:
      return ShapeType::ellipsoid;
    case mjGEOM_CYLINDER:
      return ShapeType::cylinder;
    case mjGEOM_BOX:
      return ShapeType::box;
    default:
      return std::nullopt;
  }
}

TriMesh geom_mesh(const mjModel& m, int geom, double resolution) {
  switch (m.geom_type[geom]) {
    case mjGEOM_MESH:
      return compiled_mesh(m, geom);
    case mjGEOM_HFIELD:
      return height_field_mesh(m, geom);
    case mjGEOM_SDF:
      // Without a plugin MuJoCo takes the distance from the geom's mesh.
      return m.geom_plugin[geom] < 0 ? compiled_mesh(m, geom) : sdf_mesh(m, geom, resolution);
    default:
      throw Error(
          "only plane, sphere, capsule, ellipsoid, cylinder, box, mesh, hfield and sdf can be touched "
          "hydroelastically");
  }
}

}  // namespace

Shape geom_shape(const mjModel& m, int geom, double resolution) {
  Shape shape;
  shape.size = vec3(m.geom_size + 3 * geom);
  if (const auto type = primitive_type(m.geom_type[geom])) {
    shape.type = *type;
    return shape;
  }
  shape.type = ShapeType::mesh;
  if (m.geom_type[geom] == mjGEOM_HFIELD) shape.rigid_only = "a height field";
  if (m.geom_type[geom] == mjGEOM_SDF) shape.rigid_only = "a signed distance function";
  try {
    shape.mesh = std::make_shared<const TriMesh>(geom_mesh(m, geom, resolution));
  } catch (const Error& error) {
    throw Error("geom \"" + geom_name(m, geom) + "\": " + error.message());
  }
  return shape;
}

bool can_collide(const mjModel& m, int geom) {
  return m.geom_contype[geom] != 0 || m.geom_conaffinity[geom] != 0;
}

bool are_bodies_excluded(const mjModel& m, int a, int b) {
  const int body_a = m.geom_bodyid[a], body_b = m.geom_bodyid[b];
  const int signature = (std::min(body_a, body_b) << 16) + std::max(body_a, body_b);
  const std::span signatures(m.exclude_signature, static_cast<std::size_t>(m.nexclude));
  return std::ranges::find(signatures, signature) != signatures.end();
}

bool can_body_touch(const mjModel& m, int geom, int other) {
  const int body = m.geom_bodyid[geom];
  for (int i = 0; i < m.npair; ++i) {
    const int bodies[] = {m.geom_bodyid[m.pair_geom1[i]], m.geom_bodyid[m.pair_geom2[i]]};
    if (m.pair_geom1[i] == other && bodies[1] == body) return true;
    if (m.pair_geom2[i] == other && bodies[0] == body) return true;
  }
  if (are_bodies_excluded(m, geom, other)) return false;
  for (int i = 0; i < m.body_geomnum[body]; ++i)
    if (would_collide(m, m.body_geomadr[body] + i, other)) return true;
  return false;
}

bool would_collide(const mjModel& m, int a, int b) {
  if (((m.geom_contype[a] & m.geom_conaffinity[b]) | (m.geom_contype[b] & m.geom_conaffinity[a])) == 0) return false;
  return can_bodies_collide(m, a, b);
}

bool can_bodies_collide(const mjModel& m, int a, int b) {
  const int weld_a = m.body_weldid[m.geom_bodyid[a]], weld_b = m.body_weldid[m.geom_bodyid[b]];
  if (weld_a == weld_b) return false;
  if (weld_a == 0 || weld_b == 0 || (m.opt.disableflags & mjDSBL_FILTERPARENT) != 0) return true;
  return m.body_weldid[m.body_parentid[weld_a]] != weld_b && m.body_weldid[m.body_parentid[weld_b]] != weld_a;
}

TriMeshPtr drawn_primitive(int type, const dvec3& size) {
  switch (type) {
    case mjGEOM_SPHERE:
      return std::make_shared<const TriMesh>(make_drawn_ellipsoid(dvec3(size.x)));
    case mjGEOM_CAPSULE:
      return std::make_shared<const TriMesh>(make_drawn_capsule(size.x, size.y));
    case mjGEOM_CYLINDER:
      return std::make_shared<const TriMesh>(make_drawn_cylinder(size.x, size.y));
    case mjGEOM_ELLIPSOID:
      return std::make_shared<const TriMesh>(make_drawn_ellipsoid(size));
    case mjGEOM_BOX:
      return std::make_shared<const TriMesh>(make_box(size));
    default:
      return nullptr;
  }
}

TriMeshPtr drawn_mesh(const mjModel& m, int geom) {
  const dvec3 size(m.geom_size[3 * geom], m.geom_size[3 * geom + 1], m.geom_size[3 * geom + 2]);
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE: {  // half sizes, 0 for infinite: then as large as the scene
      const double x = size.x > 0 ? size.x : 2 * m.stat.extent, y = size.y > 0 ? size.y : 2 * m.stat.extent;
      return std::make_shared<const TriMesh>(std::vector<dvec3>{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}},
                                             std::vector<ivec3>{{0, 1, 2}, {0, 2, 3}});
    }
    case mjGEOM_HFIELD:
      return std::make_shared<const TriMesh>(height_field_mesh(m, geom));
    case mjGEOM_MESH:
    case mjGEOM_SDF:
      return m.geom_dataid[geom] < 0 ? nullptr : std::make_shared<const TriMesh>(compiled_mesh(m, geom));
    default:
      return drawn_primitive(m.geom_type[geom], size);
  }
}

}  // namespace taxel
