#include "core/sim/model/drawn_mesh.h"

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

}  // namespace taxel
