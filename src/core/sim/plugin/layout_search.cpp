#include "core/sim/plugin/layout_search.h"

#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Returns the path in the first folder that has the file `relative`. MuJoCo before 3.17 does not say in which folder
/// its meshes are, so that a path from there to the folder of the scene ("../tip.taxels.json") leads elsewhere: then
/// the file without its folders is taken from the working directory, which is the folder of the scene in such programs.
/// Throws Error naming all folders if none has it.
fs::path find_file(const fs::path& relative, const std::vector<fs::path>& folders, const std::string& what) {
  std::error_code ignored;
  if (relative.is_absolute()) return relative;
  std::string tried;
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / relative, ignored)) return folder / relative;
    tried += (tried.empty() ? "" : ", ") + fs::absolute(folder, ignored).lexically_normal().string();
  }
  if (relative.has_parent_path() && fs::is_regular_file(relative.filename(), ignored))
    return fs::absolute(relative.filename(), ignored);
  throw Error(what + " \"" + relative.string() + "\" not found; folders tried: " + tried);
}

bool is_json_text(const std::string& value) {
  const std::size_t first = value.find_first_not_of(" \t\r\n");
  return first != std::string::npos && value[first] == '{';
}

/// Returns true if the bytes of the file are the whole mesh. A .gltf has buffers in other files.
bool is_one_mesh_file(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return is_mesh_file(file) && extension != ".gltf";
}

}  // namespace

FoundLayout find_layout(const std::string& value, const std::vector<fs::path>& folders) {
  if (!is_json_text(value)) {
    const fs::path file = find_file(value, folders, "layout file");
    return {read_layout(file), file, ""};
  }
  const std::string name = "layout in the scene";
  Layout layout = parse_layout(value, name);
  try {
    const fs::path mesh = find_file(layout.mesh.file, folders, "mesh file");
    layout.mesh.file = fs::absolute(mesh).string();
    return {std::move(layout), fs::absolute(mesh).parent_path() / name, ""};
  } catch (const Error& error) {
    return {std::move(layout), name, error.message()};
  }
}

SensorModelPtr compile_layout(const FoundLayout& found, const std::function<TriMeshPtr()>& mesh_of_scene) {
  const fs::path file = mesh_path(found.layout, found.file);
  const std::string name = found.file.string(), text = layout_to_json(found.layout);
  const auto build = [&](const LoadedMesh& loaded) {
    SensorBuild how;
    how.cache = parts_cache();
    return build_sensor_model(found.layout, loaded.mesh, loaded.sha256, name, how);
  };
  std::error_code ignored;
  if (!found.no_mesh.empty() || !fs::exists(file, ignored)) {
    if (const TriMeshPtr mesh = mesh_of_scene())
      return share_model({name, text, hash_of_mesh(*mesh)}, [&] { return build({mesh, "", {}, {}}); });
    if (!found.no_mesh.empty()) throw Error(found.no_mesh);
  }
  if (!is_one_mesh_file(file)) {
    const LoadedMesh loaded = load_mesh(file, found.layout.mesh.scale);
    return share_model({name, text, loaded.sha256, hash_of_mesh(*loaded.mesh)}, [&] { return build(loaded); });
  }
  const std::string bytes = read_file(file);
  return share_model({name, text, file.string(), sha256_hex(bytes)},
                     [&] { return build(read_mesh(bytes, file, found.layout.mesh.scale)); });
}

}  // namespace taxel
