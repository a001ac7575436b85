#include "core/sim/model/scene_view.h"

#include <algorithm>

#include "core/mesh/make/primitives.h"
#include "core/sim/model/geometry.h"

namespace taxel {
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

std::vector<SceneGeom> drawable_geoms(const mjModel& m, std::vector<int>& geoms) {
  std::vector<SceneGeom> drawn;
  geoms.clear();
  for (int g = 0; g < m.ngeom; ++g) {
    const int material = m.geom_matid[g];
    const float* rgba = material >= 0 ? m.mat_rgba + 4 * material : m.geom_rgba + 4 * g;
    if (!(rgba[3] > 0)) continue;
    SceneGeom geom;
    geom.name = geom_name(m, g);
    geom.body = body_name(m, m.geom_bodyid[g]);
    geom.body_index = m.geom_bodyid[g];
    geom.mesh = drawn_mesh(m, g);
    if (geom.mesh == nullptr) continue;
    geom.rgba = {rgba[0], rgba[1], rgba[2], rgba[3]};
    geom.plane = m.geom_type[g] == mjGEOM_PLANE;
    geom.group = std::clamp(m.geom_group[g], 0, mjNGROUP - 1);  // clamped as in MuJoCo's viewer
    drawn.push_back(std::move(geom));
    geoms.push_back(g);
  }
  return drawn;
}

}  // namespace taxel
