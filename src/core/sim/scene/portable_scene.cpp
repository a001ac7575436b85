// A loaded scene as a folder of its own: every asset and layout copied beside scene.xml under a plain name.
#include <fmt/format.h>

#include <array>
#include <map>

#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/layout/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/xml_attributes.h"

namespace taxel {
namespace {

/// Element name and file as the scene says it -> name of the copy.
using Renamed = std::map<std::pair<std::string, std::string>, std::string>;

/// Reads the files of all assets of one kind. `addresses`: of their resolved paths in the model.
void copy_assets(const CompiledScene& scene, mjtObj type, const std::string& tag, const int* addresses,
                 const std::function<const mjString*(mjsElement*)>& file_of, SceneFiles& out, Renamed& renamed) {
  mjSpec* spec = scene.spec.get();
  for (mjsElement* e = mjs_firstElement(spec, type); e != nullptr; e = mjs_nextElement(spec, e)) {
    const int id = mjs_getId(e);
    const std::string file = mjs_getString(file_of(e));
    if (file.empty() || addresses[id] < 0) continue;
    std::string& name = renamed[{tag, file}];
    if (!name.empty()) continue;
    const std::filesystem::path path = scene.model->paths + addresses[id];
    name = fmt::format("{}_{}{}", tag, id, path.extension().string());
    out.files.push_back({name, read_file(path)});
  }
}

Renamed copy_all_assets(const CompiledScene& scene, SceneFiles& out) {
  const mjModel& m = *scene.model;
  Renamed renamed;
  copy_assets(
      scene, mjOBJ_MESH, "mesh", m.mesh_pathadr, [](auto* e) { return mjs_asMesh(e)->file; }, out, renamed);
  copy_assets(
      scene, mjOBJ_HFIELD, "hfield", m.hfield_pathadr, [](auto* e) { return mjs_asHField(e)->file; }, out, renamed);
  copy_assets(
      scene, mjOBJ_SKIN, "skin", m.skin_pathadr, [](auto* e) { return mjs_asSkin(e)->file; }, out, renamed);
  copy_assets(
      scene, mjOBJ_TEXTURE, "texture", m.tex_pathadr, [](auto* e) { return mjs_asTexture(e)->file; }, out, renamed);
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

/// Writes the layouts with their meshes; value of the key `layout` -> name of the copy.
std::map<std::string, std::string> copy_layouts(const CompiledScene& scene, const mjData& data, SceneFiles& out) {
  std::map<std::string, std::string> layouts;
  for (const int instance : sensor_instances(*scene.model)) {
    const HydroInstance* sensor = find_sensor(data, instance);
    if (sensor == nullptr || sensor->model() == nullptr) continue;
    std::string& name = layouts[sensor->config().layout];
    if (!name.empty()) continue;
    name = fmt::format("sensor_{}.taxels.json", instance);
    const std::string mesh_name = fmt::format("sensor_{}.obj", instance), mesh = obj_text(*sensor->model()->mesh);
    Layout layout = sensor->model()->layout;
    layout.mesh = {mesh_name, dvec3(1), sha256_hex(mesh)};
    out.files.push_back({mesh_name, mesh});
    out.files.push_back({name, layout_to_json(layout)});
  }
  return layouts;
}

}  // namespace

SceneFiles portable_scene(const CompiledScene& scene, const mjData& data) {
  SceneFiles out;
  const Renamed renamed = copy_all_assets(scene, out);
  const std::map<std::string, std::string> layouts = copy_layouts(scene, data, out);
  const auto change = [&](const XmlAttribute& a) -> std::optional<std::string> {
    if (a.tag == "compiler" && (a.name == "meshdir" || a.name == "texturedir" || a.name == "assetdir")) return "";
    if (a.tag == "texture" && a.name.starts_with("file") && a.name != "file")
      throw Error("scene.xml", "a texture of one file per side cannot be copied: " + a.value);
    if (a.name == "file") {
      const auto found = renamed.find({a.tag, a.value});
      if (found != renamed.end()) return found->second;
    }
    if (a.tag == "config" && a.name == "value" && a.previous == "layout") {
      const auto found = layouts.find(a.value);
      if (found != layouts.end()) return found->second;
    }
    return std::nullopt;
  };
  out.xml = change_attributes(saved_xml(scene.spec.get()), change);
  return out;
}

}  // namespace taxel
