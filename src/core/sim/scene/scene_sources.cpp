#include "core/sim/scene/scene_sources.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/layout_json.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/plugin/sensor_config.h"
#include "core/sim/scene/xml_attributes.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSpace = " \t\r\n";

/// Value of the attribute `file` in the text of a tag; empty: it has none.
std::string file_attribute(std::string_view tag) {
  for (std::size_t at = tag.find("file"); at != std::string_view::npos; at = tag.find("file", at + 1)) {
    if (at == 0 || kSpace.find(tag[at - 1]) == std::string_view::npos) continue;
    const std::size_t equals = tag.find_first_not_of(kSpace, at + 4);
    if (equals == std::string_view::npos || tag[equals] != '=') continue;
    const std::size_t quote = tag.find_first_not_of(kSpace, equals + 1);
    if (quote == std::string_view::npos || (tag[quote] != '"' && tag[quote] != '\'')) continue;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (end == std::string_view::npos) continue;
    return xml_unescaped(std::string(tag.substr(quote + 1, end - quote - 1)));
  }
  return "";
}

struct NamedFile {
  std::string name;
  bool model = false;  ///< of a scene of its own
};

/// What the tags `include` and `model` of MJCF text name.
std::vector<NamedFile> named_files(std::string_view xml) {
  std::vector<NamedFile> files;
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', at)) {
    const bool comment = xml.substr(at).starts_with("<!--");
    const std::string_view close = comment ? "-->" : ">";
    const std::size_t end = xml.find(close, at);
    if (end == std::string_view::npos) break;
    const std::string_view tag = xml.substr(at + 1, end - at - 1);
    at = end + close.size();
    if (comment) continue;
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/"));
    const bool model = name == "model";
    if (name != "include" && !model) continue;
    if (std::string file = file_attribute(tag); !file.empty()) files.push_back({std::move(file), model});
  }
  return files;
}

/// `scene`: the file beside which names are looked for first.
void find_included(const fs::path& file, const fs::path& scene, std::set<fs::path>& found) {
  std::string xml;
  try {
    xml = read_file(file);
  } catch (const Error&) {
    return;
  }
  std::error_code ignored;
  for (const NamedFile& named : named_files(xml)) {
    for (const fs::path& from : {scene, file}) {
      const fs::path path = (from.parent_path() / named.name).lexically_normal();
      if (!fs::is_regular_file(path, ignored)) continue;
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
