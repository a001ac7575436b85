#include "core/sim/plugin/pairs/geom_body.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "core/hydro/hydro_body.h"
#include "core/mesh/repair/repair.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {
namespace {

template <class Number>
std::string hash_of_part(const Number* all, int first, int count) {
  return hash_of_numbers(std::span<const Number>(all + first, static_cast<std::size_t>(count)));
}

std::string mesh_content(const mjModel& m, int mesh) {
  return hash_of_part(m.mesh_vert, 3 * m.mesh_vertadr[mesh], 3 * m.mesh_vertnum[mesh]) +
         hash_of_part(m.mesh_face, 3 * m.mesh_faceadr[mesh], 3 * m.mesh_facenum[mesh]) +
         hash_of_part(m.mesh_pos, 3 * mesh, 3) + hash_of_part(m.mesh_quat, 4 * mesh, 4);
}

std::string height_field_content(const mjModel& m, int id) {
  const int size[] = {m.hfield_nrow[id], m.hfield_ncol[id]};
  return hash_of_part(size, 0, 2) + hash_of_part(m.hfield_size, 4 * id, 4) +
         hash_of_part(m.hfield_data, static_cast<int>(m.hfield_adr[id]), size[0] * size[1]);
}

}  // namespace

std::optional<std::string> geom_content(const mjModel& m, int geom) {
  const int type = m.geom_type[geom], asset = m.geom_dataid[geom];
  if (type == mjGEOM_SDF && m.geom_plugin[geom] >= 0) return std::nullopt;
  const std::vector<mjtNum> numbers = {static_cast<mjtNum>(type), m.geom_size[3 * geom], m.geom_size[3 * geom + 1],
                                       m.geom_size[3 * geom + 2], m.stat.extent};  // of it an infinite plane is drawn
  std::string content = hash_of_numbers(std::span(numbers));
  if (asset >= 0 && (type == mjGEOM_MESH || type == mjGEOM_SDF)) content += mesh_content(m, asset);
  if (asset >= 0 && type == mjGEOM_HFIELD) content += height_field_content(m, asset);
  return content;
}

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

/// Repairs the mesh of a geom. Throws Error that names the geom.
RepairedMeshPtr repair_geom_mesh(Shape& shape, const OtherMaterial& other, const std::string& name) {
  try {
    return repair_touched_mesh(shape, other.material, other.repair);
  } catch (const Error& error) {
    throw Error("geom \"" + name + "\": " + error.message());
  }
}

NotedBody make_geom_body(const mjModel& m, int geom, const OtherMaterial& other) {
  const std::string name = geom_name(m, geom);
  NotedBody made;
  made.shape = unrepaired_shape(m, geom, other);
  if (const RepairedMeshPtr repaired = repair_geom_mesh(made.shape, other, name))
    made.repair = fmt::format("geom \"{}\": {}", name, repair_summary(repaired->report));
  made.body = share_body(made.shape, other.material, name);
  return made;
}

PartKey key_of(const mjModel& m, int geom, const std::string& content, const OtherMaterial& other) {
  const Material& material = other.material;
  std::vector<double> numbers{material.modulus,
                              material.thickness,
                              material.dissipation,
                              material.friction,
                              other.resolution,
                              static_cast<double>(material.field),
                              static_cast<double>(material.faces),
                              static_cast<double>(other.repair)};
  const std::vector<double> law = numbers_of(material.law);
  numbers.insert(numbers.end(), law.begin(), law.end());
  return {geom_name(m, geom), content, hash_of_numbers(std::span<const double>(numbers))};
}

NotedBodyPtr share_geom_body(const mjModel& m, int geom, const OtherMaterials& materials) {
  const OtherMaterial other = material_of(m, materials, geom);
  const auto make = [&] { return make_geom_body(m, geom, other); };
  const std::optional<std::string> content = geom_content(m, geom);
  return content ? share_noted_body(key_of(m, geom, *content, other), make) : std::make_shared<const NotedBody>(make());
}

}  // namespace

Shape geom_body_shape(const mjModel& m, int geom, const OtherMaterials& materials) {
  return share_geom_body(m, geom, materials)->shape;
}

HydroBodyPtr geom_body(const mjModel& m, int geom, const OtherMaterials& materials, std::string& repair) {
  const NotedBodyPtr shared = share_geom_body(m, geom, materials);
  repair = shared->repair;
  return {shared, shared->body.get()};
}

}  // namespace taxel
