// A loaded scene as a folder of its own: every asset and layout copied beside scene.xml under a plain name.
#include <fmt/format.h>

#include <array>

#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/layout/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// Copies the file at `path_address` of the model's paths; returns its new name. Empty when there is none.
std::string copy_asset(const mjModel& m, int path_address, const char* kind, int id, SceneFiles& out) {
  if (path_address < 0) return "";
  const fs::path path = m.paths + path_address;
  const std::string name = fmt::format("{}_{}{}", kind, id, path.extension().string());
  out.files.push_back({name, read_file(path)});
  return name;
}

void copy_assets(const mjModel& m, mjSpec* spec, SceneFiles& out) {
  const auto each = [&](mjtObj type, const char* kind, const int* addresses, const auto& file_of) {
    for (mjsElement* e = mjs_firstElement(spec, type); e != nullptr; e = mjs_nextElement(spec, e)) {
      const int id = mjs_getId(e);
      const std::string name = copy_asset(m, addresses[id], kind, id, out);
      if (!name.empty()) mjs_setString(file_of(e), name.c_str());
    }
  };
  each(mjOBJ_MESH, "mesh", m.mesh_pathadr, [](mjsElement* e) { return mjs_asMesh(e)->file; });
  each(mjOBJ_HFIELD, "hfield", m.hfield_pathadr, [](mjsElement* e) { return mjs_asHField(e)->file; });
  each(mjOBJ_SKIN, "skin", m.skin_pathadr, [](mjsElement* e) { return mjs_asSkin(e)->file; });
  each(mjOBJ_TEXTURE, "texture", m.tex_pathadr, [](mjsElement* e) { return mjs_asTexture(e)->file; });
  mjs_setString(spec->compiler.meshdir, "");
  mjs_setString(spec->compiler.texturedir, "");
}

std::string saved_xml(mjSpec* spec) {
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

std::string unescaped(std::string text) {
  constexpr std::array<std::pair<const char*, const char*>, 8> kEntities{{{"&quot;", "\""},
                                                                          {"&apos;", "'"},
                                                                          {"&lt;", "<"},
                                                                          {"&gt;", ">"},
                                                                          {"&#xA;", "\n"},
                                                                          {"&#x0A;", "\n"},
                                                                          {"&#10;", "\n"},
                                                                          {"&amp;", "&"}}};
  for (const auto& [entity, character] : kEntities) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string(entity).size(), character);
  }
  return text;
}

/// Replaces the value of every `<config key="layout">` that is `value`. The text is MuJoCo's own writing.
void rename_layout(std::string& xml, const std::string& value, const std::string& name) {
  const std::string before = R"(key="layout" value=")";
  for (std::size_t at = 0; (at = xml.find(before, at)) != std::string::npos;) {
    at += before.size();
    const std::size_t end = xml.find('"', at);
    if (end == std::string::npos) return;
    if (unescaped(xml.substr(at, end - at)) == value) xml.replace(at, end - at, name);
  }
}

}  // namespace

SceneFiles portable_scene(const CompiledScene& scene, const mjData& data) {
  SceneFiles out;
  const SpecHandle spec(mj_copySpec(scene.spec.get()));
  copy_assets(*scene.model, spec.get(), out);
  out.xml = saved_xml(spec.get());
  for (const int instance : sensor_instances(*scene.model)) {
    const HydroInstance* sensor = find_sensor(data, instance);
    if (sensor == nullptr || sensor->model() == nullptr) continue;
    Layout layout = sensor->model()->layout;
    const std::string mesh_name = fmt::format("sensor_{}.obj", instance), mesh = obj_text(*sensor->model()->mesh);
    const std::string layout_name = fmt::format("sensor_{}.taxels.json", instance);
    layout.mesh = {mesh_name, dvec3(1), sha256_hex(mesh)};
    out.files.push_back({mesh_name, mesh});
    out.files.push_back({layout_name, layout_to_json(layout)});
    rename_layout(out.xml, sensor->config().layout, layout_name);
  }
  return out;
}

}  // namespace taxel
