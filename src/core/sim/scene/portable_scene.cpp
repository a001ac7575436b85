// The files of a loaded scene: those that it was read from, and a folder of its own, in which every asset and layout is
// next to scene.xml under a simple name.

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/mjcf_text.h"

namespace taxel {
namespace {

/// Names of the copies, by the element and the file name in the scene.
using Renamed = std::map<std::pair<std::string, std::string>, std::string>;

/// Reads the files of all assets of one kind. `addresses` are the addresses of their resolved paths in the model.
void copy_assets(const CompiledScene& scene, mjtObj type, const std::string& tag, const int* addresses,
                 const std::function<const mjString*(mjsElement*)>& file_of, const std::string& beside, SceneFiles& out,
                 Renamed& renamed) {
  mjSpec* spec = scene.spec.get();
  for (mjsElement* e = mjs_firstElement(spec, type); e != nullptr; e = mjs_nextElement(spec, e)) {
    const int id = mjs_getId(e);
    const std::string file = mjs_getString(file_of(e));
    if (file.empty() || addresses[id] < 0) continue;
    std::string& name = renamed[{tag, file}];
    if (!name.empty()) continue;
    const std::filesystem::path path = scene.model->paths + addresses[id];
    name = beside + fmt::format("{}_{}{}", tag, id, path.extension().string());
    out.files.push_back({name, read_file(path)});
  }
}

Renamed copy_all_assets(const CompiledScene& scene, const std::string& beside, SceneFiles& out) {
  const mjModel& m = *scene.model;
  Renamed renamed;
  copy_assets(
      scene, mjOBJ_MESH, "mesh", m.mesh_pathadr, [](auto* e) { return mjs_asMesh(e)->file; }, beside, out, renamed);
  copy_assets(
      scene, mjOBJ_HFIELD, "hfield", m.hfield_pathadr, [](auto* e) { return mjs_asHField(e)->file; }, beside, out,
      renamed);
  copy_assets(
      scene, mjOBJ_SKIN, "skin", m.skin_pathadr, [](auto* e) { return mjs_asSkin(e)->file; }, beside, out, renamed);
  copy_assets(
      scene, mjOBJ_TEXTURE, "texture", m.tex_pathadr, [](auto* e) { return mjs_asTexture(e)->file; }, beside, out,
      renamed);
  return renamed;
}

std::string saved_xml(const mjSpec* spec) {
  std::array<char, 1024> reason{};
  std::string xml(1 << 16, '\0');
  while (true) {
    const int size = mj_saveXMLString(spec, xml.data(), static_cast<int>(xml.size()), reason.data(),
                                      static_cast<int>(reason.size()));
    if (size < 0) throw Error("scene.xml", std::string("cannot be written: ") + reason.data());
    if (size == 0) return xml.substr(0, xml.find('\0'));
    xml.assign(static_cast<std::size_t>(size) + 1, '\0');
  }
}

/// The layouts that were written.
struct CopiedLayouts {
  std::map<std::string, std::string> files;  ///< file of the layout, by name of the plugin instance
  /// More mesh assets, as MJCF. They only tell the plugin the folder of the layouts.
  std::string assets;
};

/// Writes the layouts with their meshes. The plugin searches layouts in the folders of meshes, and a primitive has no
/// mesh, so its sensor's mesh becomes an asset.
CopiedLayouts copy_layouts(const CompiledScene& scene, const mjData& data, const std::string& beside, SceneFiles& out) {
  CopiedLayouts copied;
  std::map<std::pair<std::string, const SensorModel*>, std::string> names;
  for (const int instance : sensor_instances(*scene.model)) {
    const HydroInstance* sensor = find_sensor(data, instance);
    if (sensor == nullptr || sensor->model() == nullptr) continue;
    const SensorConfig& config = sensor->config();
    std::string& name = names[{config.layout, config.layout.empty() ? sensor->model().get() : nullptr}];
    const std::string mesh_name = fmt::format("sensor_{}.obj", instance);
    if (name.empty()) {
      name = fmt::format("sensor_{}.taxels.json", instance);
      const std::string mesh = write_obj(*sensor->model()->mesh);
      Layout layout = layout_on_repaired_mesh(*sensor->model());
      layout.mesh = {mesh_name, dvec3(1), sha256_hex(mesh), layout.mesh.repair};
      out.files.push_back({beside + mesh_name, mesh});
      out.files.push_back({beside + name, layout_to_json(layout)});
      if (scene.model->geom_type[config.geom] != mjGEOM_MESH)
        copied.assets += fmt::format(R"(<mesh name="sensor {} of taxels" file="{}" inertia="shell"/>)", instance,
                                     xml_escaped(beside + mesh_name));
    }
    copied.files[config.name] = name;
  }
  return copied;
}

/// Returns the MJCF text with more assets.
std::string with_assets(std::string xml, const std::string& assets) {
  const std::string end = "</asset>";
  const std::size_t at = xml.find(end);
  if (assets.empty()) return xml;
  if (at != std::string::npos) return xml.insert(at, assets);
  return xml.insert(xml.find("<worldbody"), "<asset>" + assets + end);
}

}  // namespace

SceneFiles portable_scene(const CompiledScene& scene, const mjData& data, const std::string& folder) {
  SceneFiles out;
  const std::string beside = folder.empty() ? "" : folder + "/";
  const Renamed renamed = copy_all_assets(scene, beside, out);
  const CopiedLayouts layouts = copy_layouts(scene, data, beside, out);
  std::string instance;  // instance_name() at the present position in the text
  const auto change = [&](const XmlAttribute& a) -> std::optional<std::string> {
    if (a.tag == "compiler" && (a.name == "meshdir" || a.name == "texturedir" || a.name == "assetdir")) return "";
    if (a.tag == "texture" && a.name.starts_with("file") && a.name != "file")
      throw Error("scene.xml", "a texture of one file per side cannot be copied: " + a.value);
    if (a.name == "file") {
      const auto found = renamed.find({a.tag, a.value});
      if (found != renamed.end()) return found->second;
    }
    if ((a.tag == "instance" || a.tag == "plugin") && a.name == "name") instance = a.value;
    const auto layout = layouts.files.find(instance);
    if (a.tag == "config" && layout != layouts.files.end()) {
      if (a.name == "key" && a.value == "taxels") return "layout";  // the layout was handed over
      if (a.name == "value" && (a.previous == "layout" || a.previous == "taxels")) return layout->second;
    }
    return std::nullopt;
  };
  set_labels(scene.spec.get(), scene.names, false);
  const std::string xml = saved_xml(scene.spec.get());
  set_labels(scene.spec.get(), scene.names, true);
  out.xml = with_assets(change_attributes(xml, change), layouts.assets);
  return out;
}

void write_scene(const std::filesystem::path& xml_file, const SceneFiles& scene) {
  const std::filesystem::path folder = xml_file.has_parent_path() ? xml_file.parent_path() : ".";
  make_folder(folder);
  for (const SceneFile& file : scene.files) {
    make_folder((folder / file.name).parent_path());
    write_file_atomically(folder / file.name, file.bytes);
  }
  write_file_atomically(xml_file, scene.xml);
}

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
