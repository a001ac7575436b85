#include "core/sim/model/geometry.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/make/height_field.h"
#include "core/mesh/topology/weld.h"
#include "core/sim/model/mujoco_vectors.h"
#include "core/sim/model/sdf_mesh.h"

namespace taxel {
std::string object_name(const mjModel& m, mjtObj type, int id, const char* kind) {
  const char* name = mj_id2name(&m, type, id);
  return name != nullptr && *name != '\0' ? name : kind + std::string(" ") + std::to_string(id);
}

std::string geom_name(const mjModel& m, int geom) {
  return object_name(m, mjOBJ_GEOM, geom, "geom");
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

bool can_body_touch(const mjModel& m, int geom, int other) {
  const int body = m.geom_bodyid[geom], other_body = m.geom_bodyid[other];
  for (int i = 0; i < m.npair; ++i) {
    const int bodies[] = {m.geom_bodyid[m.pair_geom1[i]], m.geom_bodyid[m.pair_geom2[i]]};
    if (m.pair_geom1[i] == other && bodies[1] == body) return true;
    if (m.pair_geom2[i] == other && bodies[0] == body) return true;
  }
  const int signature = (std::min(body, other_body) << 16) + std::max(body, other_body);
  if (std::find(m.exclude_signature, m.exclude_signature + m.nexclude, signature) != m.exclude_signature + m.nexclude)
    return false;
  for (int i = 0; i < m.body_geomnum[body]; ++i)
    if (would_collide(m, m.body_geomadr[body] + i, other)) return true;
  return false;
}

bool would_collide(const mjModel& m, int a, int b) {
  if (((m.geom_contype[a] & m.geom_conaffinity[b]) | (m.geom_contype[b] & m.geom_conaffinity[a])) == 0) return false;
  const int weld_a = m.body_weldid[m.geom_bodyid[a]], weld_b = m.body_weldid[m.geom_bodyid[b]];
  if (weld_a == weld_b) return false;
  if (weld_a == 0 || weld_b == 0 || (m.opt.disableflags & mjDSBL_FILTERPARENT) != 0) return true;
  return m.body_weldid[m.body_parentid[weld_a]] != weld_b && m.body_weldid[m.body_parentid[weld_b]] != weld_a;
}

}  // namespace taxel
