// The layouts of the plugin taxel.sensor in MuJoCo scenes: JSON text, or the name of a file.
#include "core/layout/formats/mjcf/mjcf_plugin.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"

namespace taxel {
namespace {

/// Returns the elements with this name below all roots.
std::vector<XmlNode> below_all(const std::vector<XmlNode>& roots, const std::string& name) {
  std::vector<XmlNode> found;
  for (const XmlNode& root : roots)
    for (const XmlNode& child : root.children(name)) found.push_back(child);
  return found;
}

/// Returns the file of a layout, which is relative to the scene or to its folder of meshes.
std::filesystem::path find_layout_file(const std::vector<XmlNode>& roots, const std::string& name,
                                       const std::string& scene) {
  const std::filesystem::path folder = std::filesystem::path(scene).parent_path();
  std::vector<std::filesystem::path> tried{folder / name};
  for (const XmlNode& compiler : below_all(roots, "compiler"))
    for (const char* key : {"meshdir", "assetdir"})
      if (const std::optional<std::string> below = compiler.find(key)) tried.push_back(folder / *below / name);
  std::error_code ignored;
  for (const std::filesystem::path& path : tried)
    if (std::filesystem::exists(path, ignored)) return path;
  return tried.front();
}

/// Returns the path from the scene to the mesh asset with the name of this file, as the plugin finds the mesh of a
/// layout in the scene; the name itself if there is none.
std::string find_mesh_asset(const std::vector<XmlNode>& roots, const std::string& name) {
  const std::filesystem::path wanted(name);
  if (wanted.is_absolute()) return name;
  std::filesystem::path folder;
  for (const XmlNode& compiler : below_all(roots, "compiler"))
    for (const char* key : {"assetdir", "meshdir"})
      if (const std::optional<std::string> below = compiler.find(key)) folder = *below;
  for (const XmlNode& asset : below_all(roots, "asset"))
    for (const XmlNode& mesh : asset.children("mesh"))
      if (const std::filesystem::path file(mesh.text_or_empty("file")); file.filename() == wanted.filename())
        return (folder / file).string();
  return name;
}

/// Reads the layout of an instance: JSON text, or the name of a file.
ImportedLayout read_instance(const std::vector<XmlNode>& roots, const XmlNode& instance, const std::string& file) {
  ImportedLayout imported;
  std::optional<XmlNode> layout;
  for (const XmlNode& config : instance.children("config")) {
    const std::string key = config.text_or_empty("key");
    if (key == "layout") layout = config;
    if (key != "geom") continue;
    imported.geom = config.text("value");
    imported.geom_place = config.place("value");
  }
  if (!layout) instance.fail("has no <config key=\"layout\">");
  const std::string value = layout->text("value");
  LayoutOfFile read;
  if (const std::size_t first = value.find_first_not_of(" \t\r\n"); first != std::string::npos && value[first] == '{') {
    try {
      read = parse_layout_of_file(value, file);
      if (!read.layout.mesh.file.empty()) read.layout.mesh.file = find_mesh_asset(roots, read.layout.mesh.file);
    } catch (const Error& e) {
      throw Error(file, layout->place("value") + (e.where().empty() ? "" : ": " + e.where()), e.message());
    }
  } else {
    const std::filesystem::path path = find_layout_file(roots, value, file);
    read = read_layout_of_file(path);
    if (!read.layout.mesh.file.empty())
      read.layout.mesh.file = std::filesystem::absolute(mesh_path(read.layout, path)).lexically_normal().string();
    imported.notes.push_back(fmt::format("the layout is that of {}", path.string()));
  }
  imported.layout = std::move(read.layout);
  imported.has_frame = read.has_frame;
  imported.notes.insert(imported.notes.end(), read.notes.begin(), read.notes.end());
  if (imported.layout.name.empty()) imported.layout.name = instance.text_or_empty("name");
  return imported;
}

}  // namespace

std::vector<ImportedLayout> plugin_layouts(const std::vector<XmlNode>& roots, const std::string& scene) {
  std::vector<ImportedLayout> layouts;
  for (const XmlNode& extension : below_all(roots, "extension"))
    for (const XmlNode& plugin : extension.children("plugin"))
      if (plugin.text_or_empty("plugin") == "taxel.sensor")
        for (const XmlNode& instance : plugin.children("instance"))
          layouts.push_back(read_instance(roots, instance, scene));
  return layouts;
}

}  // namespace taxel
