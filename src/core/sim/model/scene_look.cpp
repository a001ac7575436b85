#include "core/sim/model/scene_look.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>

#include "core/mesh/query/closest_point.h"
#include "core/sim/model/geometry.h"

namespace taxel {
namespace {

glm::vec3 color_at(const float* rgb) {
  return {rgb[0], rgb[1], rgb[2]};
}

/// Returns the image of a texture, or null for one that is empty or has another number of channels than 1 to 4.
SceneTexturePtr texture_of(const mjModel& m, int texture) {
  SceneTexture image;
  image.cube = m.tex_type[texture] != mjTEXTURE_2D;
  image.width = m.tex_width[texture];
  image.height = m.tex_height[texture];
  image.channels = m.tex_nchannel[texture];
  if (image.width <= 0 || image.height <= 0 || image.channels < 1 || image.channels > 4) return nullptr;
  if (image.cube && image.height != 6 * image.width) return nullptr;
  const mjtByte* first = m.tex_data + m.tex_adr[texture];
  const auto bytes = static_cast<std::ptrdiff_t>(image.width) * image.height * image.channels;
  image.pixels.assign(first, first + bytes);
  return std::make_shared<const SceneTexture>(std::move(image));
}

/// The textures that materials share.
class Textures {
 public:
  explicit Textures(const mjModel& m) : m_(m) {}
  SceneTexturePtr get(int texture) {
    if (texture < 0) return nullptr;
    const auto [place, added] = made_.try_emplace(texture);
    if (added) place->second = texture_of(m_, texture);
    return place->second;
  }

 private:
  const mjModel& m_;
  std::map<int, SceneTexturePtr> made_;
};

SceneMaterial material_of(const mjModel& m, int id, Textures& textures) {
  SceneMaterial material;
  material.emission = m.mat_emission[id];
  material.specular = m.mat_specular[id];
  material.shininess = m.mat_shininess[id];
  material.reflectance = m.mat_reflectance[id];
  material.metallic = m.mat_metallic[id];
  material.roughness = m.mat_roughness[id];
  material.texture = textures.get(m.mat_texid[mjNTEXROLE * id + mjTEXROLE_RGB]);
  material.repeat = {m.mat_texrepeat[2 * id], m.mat_texrepeat[2 * id + 1]};
  material.uniform = m.mat_texuniform[id] != 0;
  return material;
}

/// Returns the places of a mesh in a texture; null if its file has none.
TextureCoordsPtr texture_coords_of(const mjModel& m, int mesh) {
  if (m.mesh_texcoordadr[mesh] < 0) return nullptr;
  const float* coords = m.mesh_texcoord + 2 * static_cast<std::ptrdiff_t>(m.mesh_texcoordadr[mesh]);
  const int* corners = m.mesh_facetexcoord + 3 * static_cast<std::ptrdiff_t>(m.mesh_faceadr[mesh]);
  TextureCoords places;
  for (int i = 0; i < 3 * m.mesh_facenum[mesh]; ++i) {
    const float* place = coords + 2 * static_cast<std::ptrdiff_t>(corners[i]);
    places.emplace_back(place[0], place[1]);
  }
  return std::make_shared<const TextureCoords>(std::move(places));
}

/// The places in textures of meshes, which geoms share.
class MeshTextureCoords {
 public:
  explicit MeshTextureCoords(const mjModel& m) : m_(m) {}
  /// Returns null unless the geom is a mesh with such places and its material has a flat texture.
  TextureCoordsPtr get(int geom, const SceneMaterial& material) {
    const int mesh = m_.geom_type[geom] == mjGEOM_MESH ? m_.geom_dataid[geom] : -1;
    if (mesh < 0 || material.texture == nullptr || material.texture->cube) return nullptr;
    const auto [place, added] = made_.try_emplace(mesh);
    if (added) place->second = texture_coords_of(m_, mesh);
    return place->second;
  }

 private:
  const mjModel& m_;
  std::map<int, TextureCoordsPtr> made_;
};

SceneLight light_of(const mjModel& m, int id) {
  SceneLight light;
  light.kind = m.light_type[id] == mjLIGHT_DIRECTIONAL ? LightKind::directional
               : m.light_type[id] == mjLIGHT_POINT     ? LightKind::point
                                                       : LightKind::spot;
  light.body = m.light_bodyid[id];
  light.p_B = vec3(m.light_pos + 3 * id);
  light.direction_B = vec3(m.light_dir + 3 * id);
  light.p_W = vec3(m.light_pos0 + 3 * id);
  light.direction_W = vec3(m.light_dir0 + 3 * id);
  light.ambient = color_at(m.light_ambient + 3 * id);
  light.diffuse = color_at(m.light_diffuse + 3 * id);
  light.specular = color_at(m.light_specular + 3 * id);
  light.casts_shadow = m.light_castshadow[id] != 0;
  light.cutoff_deg = m.light_cutoff[id];
  light.exponent = m.light_exponent[id];
  return light;
}

/// Returns whether the file sets the direction, the centre or the size of its first view. MuJoCo computes values that
/// are not set, and the compiled model has the results alone.
bool sets_view(const mjSpec& spec, const mjModel& m) {
  constexpr float kAzimuth = 90, kElevation = -45;  // MuJoCo's defaults
  return std::isfinite(spec.stat.extent) || std::isfinite(spec.stat.center[0]) || m.vis.global.azimuth != kAzimuth ||
         m.vis.global.elevation != kElevation;
}

}  // namespace

void add_look(const mjSpec& spec, const mjModel& m, const std::vector<int>& drawn, SimScene& scene) {
  Textures textures(m);
  MeshTextureCoords coords(m);
  std::map<int, SceneMaterialPtr> materials;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const int geom = drawn[i], id = m.geom_matid[geom];
    if (scene.geoms[i].plane) scene.geoms[i].plane_size = {m.geom_size[3 * geom], m.geom_size[3 * geom + 1]};
    if (id < 0) continue;
    SceneMaterialPtr& shared = materials[id];
    if (shared == nullptr) shared = std::make_shared<const SceneMaterial>(material_of(m, id, textures));
    scene.geoms[i].material = shared;
    scene.geoms[i].texture_coords = coords.get(geom, *shared);
  }
  SceneLook look;
  for (int l = 0; l < m.nlight; ++l)
    if (m.light_active[l] != 0 && m.light_type[l] != mjLIGHT_IMAGE) look.lights.push_back(light_of(m, l));
  const auto& head = m.vis.headlight;
  if (head.active != 0) look.headlight = {color_at(head.ambient), color_at(head.diffuse), color_at(head.specular)};
  for (int t = 0; t < m.ntex && look.sky == nullptr; ++t)
    if (m.tex_type[t] == mjTEXTURE_SKYBOX) look.sky = textures.get(t);
  look.haze = color_at(m.vis.rgba.haze);
  look.has_own_view = sets_view(spec, m);
  scene.look = std::make_shared<const SceneLook>(std::move(look));
}

namespace {

constexpr int kSurfacePoints = 256;

/// Returns points spread over a surface in proportion to area, the same for the same mesh.
std::vector<dvec3> spread_points(const TriMesh& mesh) {
  std::vector<dvec3> points;
  const double total = mesh.area();
  double sum = 0;
  int next = 0;
  for (int f = 0; f < mesh.face_count() && total > 0; ++f) {
    const dvec3 a = mesh.vertex(f, 0), b = mesh.vertex(f, 1), c = mesh.vertex(f, 2);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a)) / total;
    for (; next < kSurfacePoints && next + 0.5 < sum * kSurfacePoints; ++next) {
      double u = std::fmod(0.7548776662466927 * next, 1.0), v = std::fmod(0.5698402909980532 * next, 1.0);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      points.push_back(a + u * (b - a) + v * (c - a));
    }
  }
  return points;
}

/// The drawn surface of a sensor, frame M, with its search tree.
class Skin {
 public:
  explicit Skin(const SensorModel& model) {
    const bool whole = model.skin != nullptr && model.skin->mesh().face_count() == model.mesh->face_count();
    index_ = whole ? model.skin : std::make_shared<const MeshIndex>(model.mesh);
    reach_ = kCoveredDistance * model.mesh->bounds().diagonal();
  }
  [[nodiscard]] bool covers(const TriMesh& mesh, const Pose& X_MG) const {
    const std::vector<dvec3> points = spread_points(mesh);
    if (points.empty()) return false;
    const auto allowed = static_cast<std::size_t>((1 - kCoveredPart) * static_cast<double>(points.size()));
    const RigidTransform X(X_MG);
    std::size_t missed = 0;
    for (const dvec3& p : points)
      if (index_->closest_point(X(p), reach_).face < 0 && ++missed > allowed) return false;
    return true;
  }

 private:
  std::shared_ptr<const MeshIndex> index_;
  double reach_ = 0;
};

}  // namespace

void mark_covered_geoms(const mjModel& m, const mjData& d, const std::vector<int>& drawn,
                        const std::vector<int>& sensor_geoms, SimScene& scene) {
  std::map<int, std::vector<std::size_t>> sensors_of_weld;  // by welded body
  for (std::size_t s = 0; s < sensor_geoms.size(); ++s)
    sensors_of_weld[m.body_weldid[m.geom_bodyid[sensor_geoms[s]]]].push_back(s);
  std::map<std::size_t, Skin> skins;  // by sensor
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    SceneGeom& geom = scene.geoms[i];
    const auto near = sensors_of_weld.find(m.body_weldid[m.geom_bodyid[drawn[i]]]);
    if (geom.sensor >= 0 || geom.plane || geom.mesh == nullptr || near == sensors_of_weld.end()) continue;
    for (const std::size_t s : near->second) {
      const SensorModelPtr& model = scene.sensors[s];
      if (model == nullptr || model->mesh == nullptr) continue;
      const Pose X_WM = geom_pose(m, d, sensor_geoms[s]) * mesh_file_pose(m, sensor_geoms[s]);
      const Skin& skin = skins.try_emplace(s, *model).first->second;
      if (skin.covers(*geom.mesh, X_WM.inverse() * geom_pose(m, d, drawn[i]))) geom.covered_by = static_cast<int>(s);
    }
  }
}

}  // namespace taxel
