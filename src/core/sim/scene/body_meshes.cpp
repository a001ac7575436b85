// The mesh files of the bodies of a scene.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/model/geometry.h"
#include "core/sim/mujoco_handles.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/scene_layouts.h"

namespace taxel {
namespace {

std::string object_name(const mjModel& m, mjtObj type, int id) {
  const char* const name = mj_id2name(&m, type, id);
  return name == nullptr ? "" : name;
}

std::string mesh_file(const mjModel& m, int mesh) {
  return m.mesh_pathadr[mesh] < 0 ? "" : m.paths + m.mesh_pathadr[mesh];
}

/// Returns the different meshes of a body's geoms; only of those that touch nothing if these have any.
std::vector<int> meshes_of_body(const mjModel& m, int body) {
  std::vector<int> all, visual;
  for (int g = m.body_geomadr[body]; g < m.body_geomadr[body] + m.body_geomnum[body]; ++g) {
    const int mesh = m.geom_type[g] == mjGEOM_MESH ? m.geom_dataid[g] : -1;
    if (mesh < 0) continue;
    const bool touches = m.geom_contype[g] != 0 || m.geom_conaffinity[g] != 0;
    for (std::vector<int>* list : {&all, touches ? &all : &visual})
      if (std::find(list->begin(), list->end(), mesh) == list->end()) list->push_back(mesh);
  }
  return visual.empty() ? all : visual;
}

/// Returns the reason why a body has no mesh file to use, or an empty text.
std::string problem_of(const mjModel& m, const std::string& body, const std::vector<int>& meshes) {
  if (meshes.empty())
    return fmt::format("body \"{}\" has no geom with a mesh: its shapes are MuJoCo's own, which have no file", body);
  if (meshes.size() > 1)
    return fmt::format("body \"{}\" has the meshes \"{}\" and \"{}\": generate on one of their files", body,
                       object_name(m, mjOBJ_MESH, meshes[0]), object_name(m, mjOBJ_MESH, meshes[1]));
  const std::string file = mesh_file(m, meshes[0]);
  const std::string name = object_name(m, mjOBJ_MESH, meshes[0]);
  if (file.empty()) return fmt::format("the mesh \"{}\" of body \"{}\" has no file", name, body);
  if (!is_mesh_file(file))
    return fmt::format("the mesh \"{}\" of body \"{}\" is of a format that is not read", name, body);
  return "";
}

void add_body(const mjModel& m, const std::string& body, int mesh, std::vector<BodyMesh>& all) {
  const std::filesystem::path file = mesh_file(m, mesh);
  const dvec3 scale = vec3(m.mesh_scale + 3 * mesh);
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const BodyMesh& one) { return one.file == file && one.scale == scale; });
  if (known != all.end())
    known->bodies.push_back(body);
  else
    all.push_back({object_name(m, mjOBJ_MESH, mesh), file, scale, {body}});
}

}  // namespace

BodyMeshes read_body_meshes(const std::filesystem::path& scene, const std::vector<std::string>& bodies) {
  (void)register_sensor_plugin();  // false in a process that has loaded the module
  const CompiledScene compiled = load_scene(scene, {});
  const mjModel& m = *compiled.model;
  BodyMeshes out;
  for (const std::string& body : bodies) {
    const int id = mj_name2id(&m, mjOBJ_BODY, body.c_str());
    if (id < 0) throw Error(scene.string(), fmt::format("has no body \"{}\"", body));
    const std::vector<int> meshes = meshes_of_body(m, id);
    if (const std::string problem = problem_of(m, body, meshes); !problem.empty()) throw Error(scene.string(), problem);
    add_body(m, body, meshes[0], out.meshes);
  }
  if (!bodies.empty()) return out;
  for (int id = 1; id < m.nbody; ++id) {
    const std::string body = object_name(m, mjOBJ_BODY, id);
    const std::vector<int> meshes = meshes_of_body(m, id);
    if (meshes.empty() || body.empty()) continue;
    if (const std::string problem = problem_of(m, body, meshes); !problem.empty())
      out.notes.push_back(problem);
    else
      add_body(m, body, meshes[0], out.meshes);
  }
  if (out.meshes.empty()) throw Error(scene.string(), "no body with a name has a mesh file");
  return out;
}

}  // namespace taxel
