#include "core/sim/scene/scene_sources.h"

#include <tinyxml2.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/plugin/sensor_config.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

struct NamedFile {
  std::string name;
  bool model = false;  ///< of a scene of its own
};

/// What the elements `include` and `model` of MJCF name, read as MuJoCo reads it. None where it is no XML.
class FileNames : public tinyxml2::XMLVisitor {
 public:
  explicit FileNames(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) document.Accept(this);
  }
  [[nodiscard]] const std::vector<NamedFile>& files() const { return files_; }

 private:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute* /*first*/) override {
    const std::string_view name = element.Name();
    const char* const file = element.Attribute("file");
    if (file != nullptr && *file != '\0' && (name == "include" || name == "model"))
      files_.push_back({file, name == "model"});
    return true;
  }
  std::vector<NamedFile> files_;
};

/// `scene`: the file beside which names are looked for first.
void find_included(const fs::path& file, const fs::path& scene, std::set<fs::path>& found) {
  std::string xml;
  try {
    xml = read_file(file);
  } catch (const Error&) {
    return;
  }
  std::error_code ignored;
  const FileNames names(xml);
  for (const NamedFile& named : names.files()) {
    for (const fs::path& from : {scene, file}) {
      const fs::path path = (from.parent_path() / named.name).lexically_normal();
      if (!fs::exists(path, ignored)) continue;
      if (!fs::is_regular_file(path, ignored))
        throw Error(file.string(), fmt::format("{}: is not a regular file", named.name));
      if (path != scene && found.insert(path).second) find_included(path, named.model ? path : scene, found);
      break;
    }
  }
}

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

/// The model names no file of a texture that has one for each side.
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
    } catch (const Error&) {  // gone since it was read
    }
  }
}

}  // namespace

std::vector<fs::path> included_files(const fs::path& scene) {
  std::set<fs::path> found;
  find_included(scene, scene, found);
  return {found.begin(), found.end()};
}

std::vector<std::string> scene_sources(const fs::path& scene, const CompiledScene& compiled) {
  std::error_code ignored;
  const fs::path file = fs::absolute(scene, ignored).lexically_normal(), folder = file.parent_path();
  std::set<fs::path> found;
  find_included(file, file, found);
  add_assets(*compiled.model, folder, found);
  add_sides_of_textures(compiled.spec.get(), folder, found);
  add_layouts(*compiled.model, found);
  std::vector<std::string> files;
  for (const fs::path& path : found)
    if (path != file && fs::is_regular_file(path, ignored)) files.push_back(path.string());
  return files;
}

}  // namespace taxel
