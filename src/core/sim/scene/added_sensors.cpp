#include "core/sim/scene/added_sensors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/layout_source.h"
#include "core/sensor/skin_cover.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/scene/old_fields.h"

namespace taxel {
namespace {

Pose pose_in_body(const mjModel& m, int geom) {
  return {quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
}

}  // namespace

std::vector<Sister> sister_geoms(const mjModel& m, int geom, const SensorModel& model) {
  const int body = m.geom_bodyid[geom];
  constexpr double kLeastShare = 0.5;
  const Pose skin_in_body = pose_in_body(m, geom) * mesh_file_pose(m, geom);
  std::vector<Sister> sisters;
  for (int g = m.body_geomadr[body]; g < m.body_geomadr[body] + m.body_geomnum[body]; ++g) {
    if (g == geom || !can_collide(m, g)) continue;
    const TriMeshPtr surface = drawn_mesh(m, g);
    if (surface == nullptr) continue;
    const RigidTransform X_skin((skin_in_body.inverse() * pose_in_body(m, g)));
    const double share = share_within_skin(*surface, X_skin, *model.skin, model.layout.material.thickness);
    if (share >= kLeastShare) sisters.push_back({g, share});
  }
  return sisters;
}

int mesh_geom_of_body(const mjModel& m, const std::string& body, const std::string& file) {
  const int id = mj_name2id(&m, mjOBJ_BODY, body.c_str());
  if (id < 0) throw Error(file, fmt::format("has no body \"{}\"", body));
  int found = -1;
  for (int g = m.body_geomadr[id]; g < m.body_geomadr[id] + m.body_geomnum[id]; ++g) {
    if (m.geom_type[g] != mjGEOM_MESH) continue;
    if (found >= 0 && m.geom_dataid[found] != m.geom_dataid[g])
      throw Error(file, fmt::format("body \"{}\" has the meshes of \"{}\" and \"{}\": choose one with --geom", body,
                                    geom_name(m, found), geom_name(m, g)));
    if (found < 0) found = g;
  }
  if (found < 0) throw Error(file, fmt::format("body \"{}\" has no geom with a mesh", body));
  return found;
}

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

namespace {

/// Returns the sensor that was added as an instance, or null.
AddedSensor* added_as(std::vector<AddedSensor>& added, const std::string& instance) {
  const auto found = std::ranges::find(added, instance, &AddedSensor::instance);
  return found == added.end() ? nullptr : &*found;
}

std::string ids_key(const std::vector<int>& ids) {
  return fmt::format(R"(<config key="other_ids" value="{}"/>)", fmt::join(ids, " "));
}

}  // namespace

std::map<int, int> replaced_sisters(const mjModel& m, std::vector<AddedSensor>& added,
                                    std::vector<std::string>& notes) {
  std::map<int, int> sisters;
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    const AddedSensor* one = added_as(added, config.name);
    if (one == nullptr || one->keeps_sisters || !config.apply) continue;
    std::vector<std::string> replaced;
    for (const auto& [sister, share] : sister_geoms(m, config.geom, *one->model)) {
      bool is_replaced = true;
      for (int g = 0; g < m.ngeom; ++g)
        if (would_collide(m, sister, g)) is_replaced = is_replaced && std::ranges::binary_search(config.others, g);
      if (!is_replaced) {
        notes.push_back(
            fmt::format("geom \"{}\" lies within the skin on \"{}\" and keeps MuJoCo's own contacts: it "
                        "can touch geoms that the skin does not touch",
                        geom_name(m, sister), config.geom_name));
        continue;
      }
      sisters.emplace(sister, config.geom);
      replaced.push_back(fmt::format("\"{}\" ({:.0f} % of its surface)", geom_name(m, sister), 100 * share));
    }
    if (!replaced.empty())
      notes.push_back(fmt::format("the skin on \"{}\" replaces the contacts of what lies within it: {}",
                                  config.geom_name, fmt::join(replaced, ", ")));
  }
  return sisters;
}

void list_others(const mjModel& m, const std::map<int, int>& sisters, std::vector<AddedSensor>& added) {
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    AddedSensor* one = added_as(added, config.name);
    if (one == nullptr || config.others_named) continue;
    std::set<int> others;
    for (const int other : config.others) {
      const auto sister = sisters.find(other);
      others.insert(sister == sisters.end() ? other : sister->second);
    }
    one->keys += ids_key({others.begin(), others.end()});
  }
}

}  // namespace taxel
