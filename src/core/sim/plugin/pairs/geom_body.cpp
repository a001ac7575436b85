#include "core/sim/plugin/pairs/geom_body.h"

#include <fmt/format.h>

#include "core/hydro/body_cache.h"
#include "core/hydro/fields/soft_mesh.h"
#include "core/mesh/repair/repair_message.h"
#include "core/sim/model/geometry.h"

namespace taxel {
namespace {

/// Returns the configured material of a geom. Without one, the geom is rigid with its own friction.
OtherMaterial material_of(const mjModel& m, const OtherMaterials& materials, int geom, ShapeType type) {
  OtherMaterial other;
  auto found = materials.find(geom_name(m, geom));
  if (found == materials.end()) found = materials.find(kAllGeoms);
  if (found != materials.end()) other = found->second;
  if (!other.has_friction) other.material.friction = m.geom_friction[3 * geom];
  if (!other.has_field) other.material.field = type == ShapeType::mesh ? FieldKind::pad : FieldKind::medial_axis;
  return other;
}

}  // namespace

HydroBodyPtr geom_body(const mjModel& m, int geom, const OtherMaterials& materials, std::vector<std::string>& notes) {
  const std::string name = geom_name(m, geom);
  Shape shape = geom_shape(m, geom);
  const OtherMaterial other = material_of(m, materials, geom, shape.type);
  if (m.geom_type[geom] == mjGEOM_SDF && other.resolution > 0) shape = geom_shape(m, geom, other.resolution);
  shape.resolution = other.resolution;
  if (const RepairedMeshPtr repaired = repair_soft_mesh(shape, other.material))
    notes.push_back(fmt::format("geom \"{}\": {}", name, repair_summary(repaired->report)));
  return share_body(shape, other.material, name);
}

}  // namespace taxel
