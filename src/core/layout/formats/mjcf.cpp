// MuJoCo scenes: layouts of the plugin taxel.sensor (JSON text, or the name of a file), and touch sensors. A written
// scene has the mesh, a geom of it and the plugin with the whole layout as text. Here the text of one file is read;
// read_scene_layouts() (core/sim) also reads the parts that only the compiled scene has.

#include "core/layout/formats/mjcf.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/formats/text.h"

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

namespace {

std::vector<ImportedLayout> parse_mjcf(const std::string& text, const std::string& file) {
  const XmlFile xml(text, file);
  const XmlNode mujoco = xml.root();
  if (mujoco.name() != "mujoco") mujoco.fail("must be <mujoco>: the file is no MuJoCo scene");
  std::vector<ImportedLayout> layouts = plugin_layouts({mujoco}, file);
  for (ImportedLayout& one : touch_sites(mujoco)) layouts.push_back(std::move(one));
  if (layouts.empty()) throw Error(file, "holds no layout: no plugin taxel.sensor and no <touch> sensor");
  return layouts;
}

/// Returns the layout as text for a scene: the plugin searches its mesh in the folder of the geom's mesh.
std::string text_in_scene(Layout layout) {
  const std::filesystem::path mesh(layout.mesh.file);
  if (mesh.is_relative()) layout.mesh.file = mesh.filename().string();
  return xml_attribute(layout_to_json(layout));
}

WrittenLayouts write_mjcf(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a layout");
  std::string assets, instances, geoms, sensors;
  WrittenLayouts written;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const ImportedLayout& one = layouts[i];
    const Layout& layout = one.layout;
    if (layout.mesh.file.empty())
      throw Error("", layout.name, "has no mesh, which a scene needs: name it with --mesh FILE");
    const std::string number = layouts.size() > 1 ? fmt::format(" {}", i + 1) : "";
    const std::string geom = xml_attribute(one.geom.empty() ? "skin" + number : one.geom);
    assets +=
        fmt::format("    <mesh name=\"skin{}\" file=\"{}\" scale=\"{}\"/>\n", number, xml_attribute(layout.mesh.file),
                    words_of_numbers({layout.mesh.scale.x, layout.mesh.scale.y, layout.mesh.scale.z}));
    instances += fmt::format(
        "      <instance name=\"taxels{}\">\n        <config key=\"layout\" value=\"{}\"/>\n        <config "
        "key=\"geom\" "
        "value=\"{}\"/>\n      </instance>\n",
        number, text_in_scene(layout), geom);
    geoms += fmt::format(
        "    <body name=\"body of {}\">\n      <geom name=\"{}\" type=\"mesh\" mesh=\"skin{}\" contype=\"0\" "
        "conaffinity=\"0\"/>\n    </body>\n",
        geom, geom, number);
    sensors +=
        fmt::format("    <plugin name=\"taxels{}\" plugin=\"taxel.sensor\" instance=\"taxels{}\"/>\n", number, number);
    if (one.geom.empty()) written.notes.push_back(fmt::format("the geom of the sensor is named \"{}\"", geom));
  }
  written.bytes = "<mujoco>\n  <extension>\n    <plugin plugin=\"taxel.sensor\">\n" + instances +
                  "    </plugin>\n  </extension>\n  <asset>\n" + assets + "  </asset>\n  <worldbody>\n" + geoms +
                  "  </worldbody>\n  <sensor>\n" + sensors + "  </sensor>\n</mujoco>\n";
  return written;
}

bool is_mujoco(std::string_view bytes) {
  return first_element(bytes) == "mujoco";
}

}  // namespace

LayoutFormat mjcf_format() {
  LayoutFormat format{"mjcf", "MuJoCo scene with taxels", {".xml", ".mjcf"}};
  format.holds = {true, true, true, true, true, true, true, true};
  format.reads_several = format.writes_several = format.is_scene = true;
  format.is_start = is_mujoco;
  format.parse = parse_mjcf;
  format.write = write_mjcf;
  return format;
}

}  // namespace taxel
