#include "core/sim/scene/added_sensors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/query/closest_point.h"
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

std::vector<int> geoms_of_mesh(const mjModel& m, const std::string& mesh, const std::string& file) {
  const int id = mj_name2id(&m, mjOBJ_MESH, mesh.c_str());
  if (id < 0) throw Error(file, fmt::format("has no mesh \"{}\"", mesh));
  std::vector<int> geoms;
  for (int g = 0; g < m.ngeom; ++g) {
    if (m.geom_type[g] != mjGEOM_MESH || m.geom_dataid[g] != id) continue;
    const auto is_same_place = [&](int other) {
      return m.geom_bodyid[other] == m.geom_bodyid[g] &&
             std::equal(m.geom_pos + 3 * g, m.geom_pos + 3 * g + 3, m.geom_pos + 3 * other) &&
             std::equal(m.geom_quat + 4 * g, m.geom_quat + 4 * g + 4, m.geom_quat + 4 * other);
    };
    if (std::ranges::none_of(geoms, is_same_place)) geoms.push_back(g);
  }
  if (geoms.empty()) throw Error(file, fmt::format("no geom has the mesh \"{}\"", mesh));
  return geoms;
}

void expect_layout_on_geom(const mjModel& m, int geom, const SensorModel& model, const std::string& layout) {
  const int type = m.geom_type[geom];
  const char* const kind = type == mjGEOM_PLANE    ? "a plane"
                           : type == mjGEOM_HFIELD ? "a height field"
                           : type == mjGEOM_SDF    ? "a signed distance function"
                                                   : nullptr;
  if (kind != nullptr)
    throw Error(layout,
                fmt::format("geom \"{}\" is {}, which takes no skin: choose a geom with a mesh, a box, a sphere, "
                            "a capsule, a cylinder or an ellipsoid",
                            geom_name(m, geom), kind));
  if (type == mjGEOM_MESH) {
    const dvec3 scale = vec3(m.mesh_scale + 3 * m.geom_dataid[geom]), own = model.layout.mesh.scale;
    if ((scale.x * scale.y * scale.z < 0) != (own.x * own.y * own.z < 0)) {
      const int axis = scale.x * own.x < 0 ? 0 : scale.y * own.y < 0 ? 1 : 2;
      throw Error(layout,
                  fmt::format("geom \"{}\" has the mesh of the other hand: its scale is {} {} {}, that of the layout "
                              "{} {} {}. `taxel convert LAYOUT MIRRORED --mirror {}` mirrors the layout",
                              geom_name(m, geom), scale.x, scale.y, scale.z, own.x, own.y, own.z, "xyz"[axis]));
    }
  }
  const TriMeshPtr surface = drawn_mesh(m, geom);
  if (surface == nullptr || !(surface->area() > 0))
    throw Error(layout, fmt::format("geom \"{}\" has a surface without area", geom_name(m, geom)));
  constexpr double kMaxShare = 0.25;
  const double extent = surface->bounds().diagonal();
  const RigidTransform X_GM(mesh_file_pose(m, geom));
  const MeshIndex index(surface);
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const Taxel& taxel : model.layout.taxels) {
    const double distance = index.closest_point(X_GM(taxel.center)).distance;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  constexpr double kMaxRatio = 100;  // of sizes; metres and millimetres differ by 1000
  const double ratio = model.mesh->bounds().diagonal() / extent;
  const bool has_wrong_unit = ratio > kMaxRatio || ratio * kMaxRatio < 1;
  if (farthest <= kMaxShare * extent && !has_wrong_unit) return;
  const std::string unit = has_wrong_unit
                               ? fmt::format(", and its mesh is {:.3g} times as large: is /mesh/scale right?", ratio)
                               : ": it is the layout of another mesh or place";
  throw Error(layout, fmt::format("lies elsewhere: its taxels are {:.3g} to {:.3g} mm from the surface of geom \"{}\", "
                                  "which is {:.3g} mm large{}",
                                  1e3 * nearest, 1e3 * farthest, geom_name(m, geom), 1e3 * extent, unit));
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
    const std::string name = geom_name(m, geom);
    const bool is_quoted = name.find(',') != std::string::npos;
    names += fmt::format("{}{}{}{}", geom > 0 ? ", " : "", is_quoted ? "\"" : "", name, is_quoted ? "\"" : "");
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

/// Returns true if every geom that MuJoCo lets collide with `geom` is one of `others`, which are ascending.
bool touches_only(const mjModel& m, int geom, const std::vector<int>& others) {
  for (int g = 0; g < m.ngeom; ++g)
    if (would_collide(m, geom, g) && !std::ranges::binary_search(others, g)) return false;
  return true;
}

/// Returns true if another geom of the body of `geom`, except sisters, can collide: no <exclude> of the body can then
/// replace MuJoCo's contacts of `geom` alone.
bool has_other_contacts(const mjModel& m, int geom, const std::map<int, int>& sisters) {
  const int body = m.geom_bodyid[geom];
  for (int g = m.body_geomadr[body]; g < m.body_geomadr[body] + m.body_geomnum[body]; ++g)
    if (g != geom && can_collide(m, g) && !sisters.contains(g)) return true;
  return false;
}

}  // namespace

std::map<int, int> replaced_sisters(const mjModel& m, std::vector<AddedSensor>& added,
                                    std::vector<std::string>& notes) {
  std::map<int, int> sisters;
  std::vector<std::string> skins, all_replaced;
  for (const int i : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, i);
    const AddedSensor* one = added_as(added, config.name);
    if (one == nullptr || !config.apply) continue;
    std::vector<std::string> replaced;
    const std::vector<Sister> within =
        one->keeps_sisters ? std::vector<Sister>() : sister_geoms(m, config.geom, *one->model);
    for (const auto& [sister, share] : within) {
      if (!touches_only(m, sister, config.others)) {
        notes.push_back(
            fmt::format("geom \"{}\" lies within the skin on \"{}\" and keeps MuJoCo's own contacts: it "
                        "can touch geoms that the skin does not touch",
                        geom_name(m, sister), config.geom_name));
        continue;
      }
      sisters.emplace(sister, config.geom);
      replaced.push_back(fmt::format("\"{}\" ({:.0f} % of its surface)", geom_name(m, sister), 100 * share));
    }
    if (!replaced.empty()) skins.push_back(config.geom_name);
    all_replaced.insert(all_replaced.end(), replaced.begin(), replaced.end());
    if (can_collide(m, config.geom) && has_other_contacts(m, config.geom, sisters) &&
        touches_only(m, config.geom, config.others))
      sisters.emplace(config.geom, config.geom);
  }
  const std::string names = fmt::format("{}", fmt::join(all_replaced, ", "));
  if (skins.size() == 1)
    notes.push_back(
        fmt::format("the skin on \"{}\" replaces the contacts of what lies within it: {}", skins.front(), names));
  if (skins.size() > 1)
    notes.push_back(fmt::format("{} skins replace the contacts of what lies within them: {}", skins.size(), names));
  return sisters;
}

void give_bits(const mjModel& m, const std::map<int, int>& sisters, std::vector<AddedSensor>& added) {
  for (const int i : sensor_instances(m)) {
    AddedSensor* one = added_as(added, instance_name(m, i));
    if (one == nullptr) continue;
    const int geom = read_sensor_config(m, i).geom;
    ContactBits bits;
    for (const auto& [sister, skin] : sisters)
      if (skin == geom) bits = bits | ContactBits{m.geom_contype[sister], m.geom_conaffinity[sister]};
    if (bits.any()) one->keys += bits_keys(bits);
  }
}

std::string bits_keys(const ContactBits& bits) {
  return fmt::format(R"(<config key="contype" value="{}"/><config key="conaffinity" value="{}"/>)", bits.contype,
                     bits.conaffinity);
}

}  // namespace taxel
