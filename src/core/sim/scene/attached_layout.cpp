#include "core/sim/scene/attached_layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/mesh/make/primitives.h"
#include "core/sensor/imported_source.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"
#include "core/sim/scene/old_fields.h"

namespace taxel {
namespace {

constexpr std::size_t kMaxNames = 20;  ///< largest number of geoms that an error lists

int find_geom(const mjModel& m, const std::string& name) {
  for (int geom = 0; geom < m.ngeom; ++geom)
    if (geom_name(m, geom) == name) return geom;
  return -1;
}

std::string geom_names(const mjModel& m) {
  std::string names;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (geom == static_cast<int>(kMaxNames)) return names + ", ...";
    names += (geom > 0 ? ", " : "") + geom_name(m, geom);
  }
  return names;
}

dvec3 box_half(const mjModel& m, int geom) {
  return vec3(m.geom_size + 3 * geom);
}

/// Sets the material that the fields of the scene give the geom. The pad of a box gets the largest possible thickness.
void take_material(const mjModel& m, int geom, ImportedLayout& imported) {
  Material& material = imported.layout.material;
  if (m.geom_type[geom] == mjGEOM_BOX) {
    const dvec3 half = box_half(m, geom);
    material.thickness = std::min({half.x, half.y, half.z});
  }
  const OldFields fields = old_fields(m);
  const auto field = fields.geoms.find(geom_name(m, geom));
  if (field == fields.geoms.end() || !(field->second.modulus > 0)) return;
  material.modulus = field->second.modulus;
  material.dissipation = field->second.dissipation;
  material.friction = field->second.friction;
  imported.has_material = true;
  imported.notes.push_back(fmt::format(
      "the scene's field \"cs::{}\" gives the material: modulus {} Pa, dissipation {} s/m, friction {}; thickness {} m",
      field->first, material.modulus, material.dissipation, material.friction, material.thickness));
}

/// Returns the layout on the surface of the geom itself.
ImportedSource put_on_geom(const mjModel& m, int geom, ImportedLayout imported, const std::string& file) {
  if (m.geom_type[geom] == mjGEOM_BOX) {
    LoadedMesh box;
    box.mesh = std::make_shared<const TriMesh>(make_box(box_half(m, geom)));
    return put_on_mesh(std::move(imported), std::move(box), geom_name(m, geom), dvec3(1), file);
  }
  const int mesh = m.geom_type[geom] == mjGEOM_MESH ? m.geom_dataid[geom] : -1;
  if (mesh < 0 || m.mesh_pathadr[mesh] < 0)
    throw Error(file, imported.geom_place,
                fmt::format("geom \"{}\" is neither a box nor a mesh file: name its mesh with --mesh FILE",
                            geom_name(m, geom)));
  imported.notes.push_back(fmt::format("the mesh of geom \"{}\" is taken, with its scale", geom_name(m, geom)));
  return put_on_mesh_file(std::move(imported), m.paths + m.mesh_pathadr[mesh], vec3(m.mesh_scale + 3 * mesh), file);
}

}  // namespace

ImportedLayout read_attached_layout(const SceneAttachment& attachment) {
  ImportedLayout imported = import_layout(attachment.layout, attachment.skin.sensor, attachment.skin.unit);
  const std::vector<std::string>& others = imported.other_geoms;
  const bool another = attachment.skin.sensor.empty() && !attachment.geom.empty() && imported.geom != attachment.geom &&
                       std::find(others.begin(), others.end(), attachment.geom) != others.end();
  if (another) imported = import_layout(attachment.layout, attachment.geom, attachment.skin.unit);
  if (attachment.geom.empty() && imported.geom.empty())
    throw Error(attachment.layout, "names no geom: name it with --geom NAME");
  return imported;
}

SensorModelPtr compile_attached_layout(const SceneAttachment& attachment, ImportedLayout imported,
                                       const std::string& geom, const mjModel& scene, std::vector<std::string>& notes) {
  const std::string& file = attachment.layout;
  const SkinChoice& skin = attachment.skin;
  const int id = find_geom(scene, geom);
  if (id < 0)
    throw Error(file, attachment.geom.empty() ? imported.geom_place : "--geom",
                fmt::format("the scene has no geom \"{}\"; it has {}", geom, geom_names(scene)));
  if (skin.mesh.empty() && skin.scale) throw Error(file, "--scale", "goes with --mesh");
  take_material(scene, id, imported);
  const ImportedSource read = skin.mesh.empty() ? put_on_geom(scene, id, std::move(imported), file)
                                                : put_on_mesh_file(std::move(imported), skin.mesh, skin.scale, file);
  for (const std::string& note : read.notes) notes.push_back(file + ": " + note);
  return build_sensor_model(read.source);
}

}  // namespace taxel
