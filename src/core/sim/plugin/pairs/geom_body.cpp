#include "core/sim/plugin/pairs/geom_body.h"

#include <fmt/format.h>

#include <array>

#include "core/hydro/body_cache.h"
#include "core/hydro/fields/soft_mesh.h"
#include "core/mesh/repair/repair_message.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/shared/geom_content.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {
namespace {

/// Returns the configured material of a geom. Without one, the geom is rigid with its own friction.
OtherMaterial material_of(const mjModel& m, const OtherMaterials& materials, int geom) {
  const int type = m.geom_type[geom];
  const bool mesh = type == mjGEOM_MESH || type == mjGEOM_HFIELD || type == mjGEOM_SDF;
  OtherMaterial other;
  auto found = materials.find(geom_name(m, geom));
  if (found == materials.end()) found = materials.find(kAllGeoms);
  if (found != materials.end()) other = found->second;
  if (!other.has_friction) other.material.friction = m.geom_friction[3 * geom];
  if (!other.has_field) other.material.field = mesh ? FieldKind::pad : FieldKind::medial_axis;
  return other;
}

/// Returns the shape of a geom before its repair.
Shape unrepaired_shape(const mjModel& m, int geom, const OtherMaterial& other) {
  Shape shape = geom_shape(m, geom, m.geom_type[geom] == mjGEOM_SDF ? other.resolution : 0);
  shape.resolution = other.resolution;
  return shape;
}

NotedBody make_geom_body(const mjModel& m, int geom, const OtherMaterial& other) {
  NotedBody made;
  const std::string name = geom_name(m, geom);
  Shape shape = unrepaired_shape(m, geom, other);
  if (const RepairedMeshPtr repaired = repair_soft_mesh(shape, other.material))
    made.notes.push_back(fmt::format("geom \"{}\": {}", name, repair_summary(repaired->report)));
  made.body = share_body(shape, other.material, name);
  return made;
}

PartKey key_of(const mjModel& m, int geom, const std::string& content, const OtherMaterial& other) {
  const Material& material = other.material;
  const std::array numbers{material.modulus,
                           material.thickness,
                           material.dissipation,
                           material.friction,
                           other.resolution,
                           static_cast<double>(material.field),
                           static_cast<double>(material.faces)};
  return {geom_name(m, geom), content, hash_of_numbers(std::span<const double>(numbers))};
}

}  // namespace

Shape geom_body_shape(const mjModel& m, int geom, const OtherMaterials& materials) {
  const OtherMaterial other = material_of(m, materials, geom);
  Shape shape = unrepaired_shape(m, geom, other);
  repair_soft_mesh(shape, other.material);
  return shape;
}

HydroBodyPtr geom_body(const mjModel& m, int geom, const OtherMaterials& materials, std::vector<std::string>& notes) {
  const OtherMaterial other = material_of(m, materials, geom);
  const auto make = [&] { return make_geom_body(m, geom, other); };
  const std::optional<std::string> content = geom_content(m, geom);
  const NotedBodyPtr shared =
      content ? share_noted_body(key_of(m, geom, *content, other), make) : std::make_shared<const NotedBody>(make());
  notes.insert(notes.end(), shared->notes.begin(), shared->notes.end());
  return {shared, shared->body.get()};
}

}  // namespace taxel
