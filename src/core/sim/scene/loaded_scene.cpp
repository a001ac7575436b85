#include "core/sim/scene/loaded_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/xml_attributes.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// MuJoCo's message on one line: a plugin's reason comes twice, and line breaks would break our own messages.
std::string one_line(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    at = end + 1;
  }
  std::string joined;
  for (const std::string& line : lines) joined += (joined.empty() ? "" : "; ") + line;
  return joined;
}

void compile(CompiledScene& scene, const mjVFS* vfs, const std::string& name) {
  scene.model.reset(mj_compile(scene.spec.get(), vfs));
  if (scene.model == nullptr) throw Error(name, one_line(mjs_getError(scene.spec.get())));
}

CompiledScene parse_and_compile(const std::string& file, const mjVFS* vfs, const std::string& name) {
  CompiledScene scene;
  std::array<char, 2048> reason{};
  scene.spec.reset(mj_parseXML(file.c_str(), vfs, reason.data(), static_cast<int>(reason.size())));
  if (scene.spec == nullptr) throw Error(name, one_line(reason.data()));
  compile(scene, vfs, name);
  return scene;
}

/// Whether every contact that MuJoCo would make between the two bodies is of the sensor with a geom it touches.
bool only_sensor_contacts(const mjModel& m, const SensorConfig& config, int body_a, int body_b) {
  for (int a = 0; a < m.ngeom; ++a) {
    for (int b = 0; b < m.ngeom; ++b) {
      if (m.geom_bodyid[a] != body_a || m.geom_bodyid[b] != body_b || !would_collide(m, a, b)) continue;
      const bool touched = std::find(config.others.begin(), config.others.end(), b) != config.others.end();
      if (a != config.geom || !touched) return false;
    }
  }
  return true;
}

std::string spec_body_name(mjSpec* spec, int body) {
  for (mjsElement* e = mjs_firstElement(spec, mjOBJ_BODY); e != nullptr; e = mjs_nextElement(spec, e)) {
    if (mjs_getId(e) != body) continue;
    if (*mjs_getString(mjs_getName(e)) == '\0') mjs_setName(e, fmt::format("taxel body {}", body).c_str());
    return mjs_getString(mjs_getName(e));
  }
  return "";
}

/// Takes MuJoCo's own contact away from the pairs of the attached sensor (the last instance).
void exclude_contacts(CompiledScene& scene) {
  const mjModel& m = *scene.model;
  const SensorConfig config = read_sensor_config(m, sensor_instances(m).back());
  const int sensor_body = m.geom_bodyid[config.geom];
  std::vector<int> bodies;
  for (const int geom : config.others) {
    const int body = m.geom_bodyid[geom];
    if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) continue;
    bodies.push_back(body);
    if (!would_collide(m, config.geom, geom) || !only_sensor_contacts(m, config, sensor_body, body)) continue;
    mjsExclude* exclude = mjs_addExclude(scene.spec.get());
    mjs_setString(exclude->bodyname1, spec_body_name(scene.spec.get(), sensor_body).c_str());
    mjs_setString(exclude->bodyname2, spec_body_name(scene.spec.get(), body).c_str());
  }
}

}  // namespace

CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name) {
  Vfs vfs;
  vfs.add("scene.xml", xml);
  for (const SceneFile& file : files) vfs.add(file.name, file.bytes);
  return parse_and_compile("scene.xml", vfs.get(), name);
}

CompiledScene load_scene(const fs::path& scene_file, const std::string& layout, const std::string& geom) {
  const std::string name = scene_file.string();
  std::error_code ignored;
  const fs::path file = fs::absolute(scene_file, ignored).lexically_normal();
  if (!fs::is_regular_file(file, ignored)) throw Error(name, "no such file");
  if (layout.empty() != geom.empty()) throw Error(name, "a layout and the geom to attach it to go together");
  if (layout.empty()) return parse_and_compile(file.string(), nullptr, name);
  // The overlay pretends to lie beside the scene, so that relative names in the scene keep their meaning.
  const fs::path overlay = file.parent_path() / (file.stem().string() + "+taxels.xml");
  const std::string xml =
      fmt::format(R"(<mujoco>
  <include file="{}"/>
  <extension><plugin plugin="{}"><instance name="attached taxels">
    <config key="layout" value="{}"/><config key="geom" value="{}"/>
  </instance></plugin></extension>
  <sensor><plugin name="taxels" plugin="{}" instance="attached taxels"/></sensor>
</mujoco>
)",
                  xml_escaped(file.filename().string()), kPluginName,
                  xml_escaped(fs::absolute(layout, ignored).string()), xml_escaped(geom), kPluginName);
  Vfs vfs;
  vfs.add(overlay.string(), xml);
  CompiledScene scene = parse_and_compile(overlay.string(), vfs.get(), name);
  exclude_contacts(scene);
  compile(scene, vfs.get(), name);
  return scene;
}

}  // namespace taxel
