#include "core/sim/model/geometry.h"

#include "core/base/error.h"
#include "core/mesh/weld.h"

namespace taxel {
namespace {

dvec3 vec3(const mjtNum* p) {
  return {p[0], p[1], p[2]};
}
dquat quat(const mjtNum* q) {
  return {q[0], q[1], q[2], q[3]};
}

std::string object_name(const mjModel& m, mjtObj type, int id, const char* kind) {
  const char* name = mj_id2name(&m, type, id);
  return name != nullptr && *name != '\0' ? name : kind + std::string(" ") + std::to_string(id);
}

}  // namespace

std::string geom_name(const mjModel& m, int geom) {
  return object_name(m, mjOBJ_GEOM, geom, "geom");
}
std::string body_name(const mjModel& m, int body) {
  return object_name(m, mjOBJ_BODY, body, "body");
}

Pose geom_pose(const mjModel& m, const mjData& d, int geom) {
  const int body = m.geom_bodyid[geom];
  const Pose X_WB{quat(d.xquat + 4 * body), vec3(d.xpos + 3 * body)};
  const Pose X_BG{quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
  return X_WB * X_BG;
}

Pose mesh_file_pose(const mjModel& m, int geom) {
  const int mesh = m.geom_dataid[geom];
  if (m.geom_type[geom] != mjGEOM_MESH || mesh < 0) return {};
  return Pose{quat(m.mesh_quat + 4 * mesh), vec3(m.mesh_pos + 3 * mesh)}.inverse();
}

TriMesh compiled_mesh(const mjModel& m, int geom) {
  const int mesh = m.geom_dataid[geom];
  const float* v = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
  const int* f = m.mesh_face + 3 * m.mesh_faceadr[mesh];
  PolygonSoup soup;
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) soup.vertices.emplace_back(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
  for (int i = 0; i < m.mesh_facenum[mesh]; ++i) soup.triangles.emplace_back(f[3 * i], f[3 * i + 1], f[3 * i + 2]);
  std::vector<std::string> notes;
  return weld(soup, dvec3(1), notes);
}

Shape geom_shape(const mjModel& m, int geom) {
  Shape shape;
  const dvec3 size = vec3(m.geom_size + 3 * geom);
  shape.size = size;
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE:
      shape.type = ShapeType::plane;
      break;
    case mjGEOM_SPHERE:
      shape.type = ShapeType::sphere;
      break;
    case mjGEOM_CAPSULE:
      shape.type = ShapeType::capsule;
      break;
    case mjGEOM_ELLIPSOID:
      shape.type = ShapeType::ellipsoid;
      break;
    case mjGEOM_CYLINDER:
      shape.type = ShapeType::cylinder;
      break;
    case mjGEOM_BOX:
      shape.type = ShapeType::box;
      break;
    case mjGEOM_MESH:
      shape.type = ShapeType::mesh;
      shape.mesh = std::make_shared<const TriMesh>(compiled_mesh(m, geom));
      break;
    default:
      throw Error("geom \"" + geom_name(m, geom) +
                  "\": only plane, sphere, capsule, ellipsoid, cylinder, box and mesh can be touched hydroelastically");
  }
  return shape;
}

bool would_collide(const mjModel& m, int a, int b) {
  if (((m.geom_contype[a] & m.geom_conaffinity[b]) | (m.geom_contype[b] & m.geom_conaffinity[a])) == 0) return false;
  const int weld_a = m.body_weldid[m.geom_bodyid[a]], weld_b = m.body_weldid[m.geom_bodyid[b]];
  if (weld_a == weld_b) return false;
  if (weld_a == 0 || weld_b == 0 || (m.opt.disableflags & mjDSBL_FILTERPARENT) != 0) return true;
  return m.body_weldid[m.body_parentid[weld_a]] != weld_b && m.body_weldid[m.body_parentid[weld_b]] != weld_a;
}

}  // namespace taxel
