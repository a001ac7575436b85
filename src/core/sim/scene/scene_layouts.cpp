#include "core/sim/scene/scene_layouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/formats/mjcf.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/model/geometry.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/mjcf_text.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr double kSameFrame = 1e-12;  ///< largest difference of frames that are taken to be the same

/// A scene and the files that it includes, as text.
struct SceneTexts {
  std::vector<std::unique_ptr<XmlFile>> files;
  std::vector<XmlNode> roots;
};

SceneTexts read_texts(const fs::path& scene) {
  SceneTexts texts;
  std::vector<fs::path> paths{scene};
  for (const fs::path& included : included_files(scene)) paths.push_back(included);
  for (const fs::path& path : paths) {
    texts.files.push_back(std::make_unique<XmlFile>(read_file(path), path.string()));
    texts.roots.push_back(texts.files.back()->root());
  }
  const XmlNode& root = texts.roots.front();
  if (root.name() != "mujoco") root.fail("must be <mujoco>: the file is no MuJoCo scene");
  return texts;
}

bool has_sensors_of_mujoco(const std::vector<XmlNode>& roots) {
  for (const XmlNode& root : roots)
    for (const XmlNode& list : root.children("sensor"))
      if (list.child("touch") || list.child("tactile")) return true;
  return false;
}

/// Returns the pose unless it is no motion up to rounding.
std::optional<Pose> pose_unless_same(const Pose& pose) {
  const dvec3 turned(pose.q.x, pose.q.y, pose.q.z);
  if (glm::length(turned) < kSameFrame && glm::length(pose.p) < kSameFrame) return std::nullopt;
  return pose;
}

/// The frame of a layout in that of a body, and the mesh in that frame.
class SkinFrame {
 public:
  /// The frame of the geom's mesh file, or that of the geom; that of the body for a negative geom.
  SkinFrame(const mjModel& m, int geom, ImportedLayout& imported) : m_(m), imported_(imported) {
    imported.has_density = imported.has_material = imported.has_frame = false;
    if (geom < 0) return;
    if (mj_id2name(&m, mjOBJ_GEOM, geom) != nullptr) imported.geom = geom_name(m, geom);
    const Pose in_body{quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
    const bool is_mesh = m.geom_type[geom] == mjGEOM_MESH && m.geom_dataid[geom] >= 0;
    to_file_ = pose_unless_same((is_mesh ? in_body * mesh_file_pose(m, geom) : in_body).inverse());
    if (is_mesh) take_mesh(geom);
  }
  [[nodiscard]] dvec3 place(const dvec3& in_body) const { return to_file_ ? *to_file_ * in_body : in_body; }
  [[nodiscard]] dvec3 direction(const dvec3& in_body) const { return to_file_ ? to_file_->rotate(in_body) : in_body; }

 private:
  void take_mesh(int geom) {
    const int mesh = m_.geom_dataid[geom];
    const std::string file = m_.mesh_pathadr[mesh] < 0 ? "" : m_.paths + m_.mesh_pathadr[mesh];
    if (file.empty() || !is_mesh_file(file)) {
      imported_.notes.push_back(
          fmt::format("the mesh of geom \"{}\" is {}: name a mesh file with --mesh FILE", geom_name(m_, geom),
                      file.empty() ? "made by MuJoCo and has no file" : "of a format that is not read"));
      return;
    }
    imported_.layout.mesh.file = file;
    imported_.layout.mesh.scale = vec3(m_.mesh_scale + 3 * mesh);
  }

  const mjModel& m_;
  ImportedLayout& imported_;
  std::optional<Pose> to_file_;
};

/// Returns the only mesh geom of a body, or its only geom, or -1.
int skin_geom(const mjModel& m, int body) {
  int mesh = -1, meshes = 0;
  for (int i = 0; i < m.body_geomnum[body]; ++i) {
    const int geom = m.body_geomadr[body] + i;
    if (m.geom_type[geom] == mjGEOM_MESH) mesh = geom, ++meshes;
  }
  if (meshes == 1) return mesh;
  return -1;
}

/// Returns the layout of the touch sites of a body, in the order of their sensors.
ImportedLayout layout_of_sites(const mjModel& m, int body, const std::vector<int>& sites) {
  ImportedLayout imported;
  imported.layout.name = body_name(m, body);
  const int geom = skin_geom(m, body);
  const SkinFrame frame(m, geom, imported);
  if (geom < 0 && m.body_geomnum[body] == 1 && mj_id2name(&m, mjOBJ_GEOM, m.body_geomadr[body]) != nullptr)
    imported.geom = geom_name(m, m.body_geomadr[body]);
  std::vector<double> users;
  for (const int site : sites) {
    Taxel taxel;
    taxel.id = static_cast<int>(imported.layout.taxels.size());
    taxel.name = object_name(m, mjOBJ_SITE, site, "site");
    taxel.center = frame.place(vec3(m.site_pos + 3 * site));
    taxel.normal = frame.direction(Pose{quat(m.site_quat + 4 * site), dvec3(0)}.rotation()[2]);
    taxel.radius = m.site_size[3 * site];
    if (m.nuser_site > 0) users.push_back(m.site_user[static_cast<std::size_t>(m.nuser_site) * site]);
    imported.layout.taxels.push_back(std::move(taxel));
  }
  take_site_ids(imported, users);
  imported.notes.push_back(fmt::format(
      "touch sites of body \"{}\": the z axis of a site is the normal, its size is the radius; positions are "
      "in the frame of {}",
      imported.layout.name, geom >= 0 ? "its mesh file" : "the body, which is taken to be that of the mesh"));
  return imported;
}

dvec3 float_vector(const float* v) {
  return {v[0], v[1], v[2]};
}

/// Returns the sum of the normals of the triangles at each vertex of a mesh, times twice their area.
std::vector<dvec3> wound_normals(const mjModel& m, int mesh) {
  std::vector<dvec3> normals(static_cast<std::size_t>(m.mesh_vertnum[mesh]), dvec3(0));
  const float* const vertices = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
  for (int face = 0; face < m.mesh_facenum[mesh]; ++face) {
    const int* const corners = m.mesh_face + 3 * (m.mesh_faceadr[mesh] + face);
    const dvec3 a = float_vector(vertices + 3 * corners[0]), b = float_vector(vertices + 3 * corners[1]),
                c = float_vector(vertices + 3 * corners[2]);
    for (int k = 0; k < 3; ++k) normals[static_cast<std::size_t>(corners[k])] += glm::cross(b - a, c - a);
  }
  return normals;
}

/// Returns which of the vectors at each vertex of a mesh is the normal: the one that is closest to the normals of the
/// triangles, all in all. MuJoCo's wedge has the normal first, its plate has it last.
int index_of_normal(const mjModel& m, int mesh, int per_vertex) {
  const std::vector<dvec3> wound = wound_normals(m, mesh);
  std::vector<double> along(static_cast<std::size_t>(per_vertex), 0.0);
  const float* vector = m.mesh_normal + 3 * m.mesh_normaladr[mesh];
  for (const dvec3& normal : wound)
    for (double& sum : along) {
      sum += glm::dot(float_vector(vector), normal);
      vector += 3;
    }
  return static_cast<int>(std::max_element(along.begin(), along.end()) - along.begin());
}

/// Returns the layout of a tactile sensor. Its mesh has one normal, or a normal and two tangents, for each vertex;
/// another number of normals does not belong to the vertices.
ImportedLayout layout_of_tactile(const mjModel& m, int sensor) {
  ImportedLayout imported;
  const int mesh = m.sensor_objid[sensor], geom = m.sensor_refid[sensor];
  const char* const name = mj_id2name(&m, mjOBJ_SENSOR, sensor);
  imported.layout.name = name != nullptr ? name : geom_name(m, geom);
  const SkinFrame frame(m, geom, imported);
  const int count = m.mesh_vertnum[mesh], per_vertex = m.mesh_normalnum[mesh] / std::max(1, count);
  imported.has_normals = m.mesh_normalnum[mesh] == per_vertex * count && (per_vertex == 1 || per_vertex == 3);
  const Pose in_body{quat(m.geom_quat + 4 * geom), vec3(m.geom_pos + 3 * geom)};
  const int normal = imported.has_normals ? index_of_normal(m, mesh, per_vertex) : 0;
  for (int i = 0; i < count; ++i) {
    Taxel taxel;
    taxel.id = i;
    taxel.center = frame.place(in_body * float_vector(m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + i)));
    if (imported.has_normals)
      taxel.normal = frame.direction(
          in_body.rotate(float_vector(m.mesh_normal + 3 * (m.mesh_normaladr[mesh] + per_vertex * i + normal))));
    imported.layout.taxels.push_back(taxel);
  }
  imported.set_all_radii_missing();
  imported.notes.push_back(
      fmt::format("tactile sensor \"{}\": a taxel at each of the {} vertices of mesh \"{}\", which MuJoCo holds with 7 "
                  "digits; it has "
                  "no radius: it is {} m (--radius M gives another)",
                  imported.layout.name, count, object_name(m, mjOBJ_MESH, mesh, "mesh"), Taxel().radius));
  if (!imported.has_normals) imported.set_all_normals_missing();
  if (!imported.has_normals) imported.notes.emplace_back("the mesh has no normal for each vertex: the skin gives them");
  return imported;
}

void add_layouts_of_mujoco(const mjModel& m, std::vector<ImportedLayout>& layouts) {
  std::vector<int> bodies;
  std::map<int, std::vector<int>> sites;  // by body
  for (int i = 0; i < m.nsensor; ++i) {
    if (m.sensor_type[i] != mjSENS_TOUCH) continue;
    const int body = m.site_bodyid[m.sensor_objid[i]];
    if (!sites.contains(body)) bodies.push_back(body);
    sites[body].push_back(m.sensor_objid[i]);
  }
  for (const int body : bodies) layouts.push_back(layout_of_sites(m, body, sites[body]));
  for (int i = 0; i < m.nsensor; ++i)
    if (m.sensor_type[i] == mjSENS_TACTILE) layouts.push_back(layout_of_tactile(m, i));
}

}  // namespace

std::vector<ImportedLayout> read_scene_layouts(const fs::path& scene) {
  const SceneTexts texts = read_texts(scene);
  std::vector<ImportedLayout> layouts = plugin_layouts(texts.roots, scene.string());
  if (has_sensors_of_mujoco(texts.roots)) {
    const CompiledScene compiled = load_scene(scene, {});
    std::vector<ImportedLayout> own;
    add_layouts_of_mujoco(*compiled.model, own);
    for (ImportedLayout& one : own) {
      const int geom = compiled.names.find(one.geom);
      if (geom >= 0 && compiled.names.is_label(static_cast<std::size_t>(geom))) one.geom.clear();
      layouts.push_back(std::move(one));
    }
  }
  if (layouts.empty())
    throw Error(scene.string(), "holds no layout: no plugin taxel.sensor, no <touch> and no <tactile> sensor");
  for (ImportedLayout& one : layouts)
    if (one.layout.name.empty()) one.layout.name = scene.stem().string();
  return layouts;
}

}  // namespace taxel
