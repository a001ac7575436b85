#include "core/sim/scene/scene_sources.h"

#include <set>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/sensor_config.h"
#include "core/sim/scene/included_files.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

void add_assets(const mjModel& m, const fs::path& folder, std::set<fs::path>& found) {
  const auto add = [&](const int* addresses, mjtSize count) {
    for (mjtSize i = 0; i < count; ++i)
      if (addresses[i] >= 0) found.insert((folder / (m.paths + addresses[i])).lexically_normal());
  };
  add(m.mesh_pathadr, m.nmesh);
  add(m.hfield_pathadr, m.nhfield);
  add(m.skin_pathadr, m.nskin);
  add(m.tex_pathadr, m.ntex);
}

/// Adds the files of textures with one file per side, which the model does not name.
void add_sides_of_textures(mjSpec* spec, const fs::path& folder, std::set<fs::path>& found) {
  constexpr int kSides = 6;
  for (mjsElement* e = mjs_firstElement(spec, mjOBJ_TEXTURE); e != nullptr; e = mjs_nextElement(spec, e)) {
    for (int side = 0; side < kSides; ++side) {
      const char* name = mjs_getInStringVec(mjs_asTexture(e)->cubefiles, side);
      if (name == nullptr || *name == '\0') continue;
      found.insert((folder / mjs_getString(spec->compiler.texturedir) / name).lexically_normal());
    }
  }
}

void add_layouts(const mjModel& m, std::set<fs::path>& found) {
  for (const int instance : sensor_instances(m)) {
    const SensorConfig config = read_sensor_config(m, instance);
    if (config.layout.empty()) continue;
    try {
      const FoundLayout layout = find_layout(config.layout, layout_folders(m, config.geom));
      found.insert(fs::absolute(layout.file).lexically_normal());
      found.insert(fs::absolute(mesh_path(layout.layout, layout.file)).lexically_normal());
    } catch (const Error&) {  // the file was deleted after it was read
    }
  }
}

}  // namespace

std::vector<std::string> scene_sources(const fs::path& scene, const CompiledScene& compiled) {
  std::error_code ignored;
  const fs::path file = fs::absolute(scene, ignored).lexically_normal(), folder = file.parent_path();
  const std::vector<fs::path> included = included_files(file);
  std::set<fs::path> found(included.begin(), included.end());
  add_assets(*compiled.model, folder, found);
  add_sides_of_textures(compiled.spec.get(), folder, found);
  add_layouts(*compiled.model, found);
  std::vector<std::string> files;
  for (const fs::path& path : found)
    if (path != file && fs::is_regular_file(path, ignored)) files.push_back(path.string());
  return files;
}

}  // namespace taxel
