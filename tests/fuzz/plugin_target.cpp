// The keys of the plugin elements of a scene and its `cs::` fields, one line `KEY=VALUE` for each. The scene around
// them is always the same, because MuJoCo's own parser is not under test.
#include <sstream>

#include "core/sim/plugin/plugin_config.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/mjcf_text.h"
#include "core/sim/scene/old_fields.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

struct Keys {
  std::string sensor, contact, fields;  ///< elements of the MJCF
};

Keys keys_of(const std::string& input) {
  Keys keys;
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t sign = line.find('=');
    if (sign == std::string::npos || line.find('\0') != std::string::npos) continue;
    const std::string key = xml_escaped(line.substr(0, sign)), value = xml_escaped(line.substr(sign + 1));
    if (key.starts_with("cs::")) {
      keys.fields += "<numeric name=\"" + key + "\" data=\"" + value + "\"/>";
    } else {
      keys.contact += "<config key=\"" + key + "\" value=\"" + value + "\"/>";
      if (key != "pairs") keys.sensor += "<config key=\"" + key + "\" value=\"" + value + "\"/>";
    }
  }
  return keys;
}

std::string scene_with(const std::string& plugin, const std::string& keys, const std::string& fields) {
  return "<mujoco><extension><plugin plugin=\"" + plugin + "\"><instance name=\"i\">" + keys +
         "</instance></plugin></extension><custom>" + fields +
         "</custom><worldbody><geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/><body><freejoint/><geom "
         "name=\"ball\" "
         "size=\".1\"/><geom name=\"box\" type=\"box\" size=\".1 .1 .1\"/></body></worldbody><sensor><plugin "
         "plugin=\"" +
         plugin + "\" instance=\"i\"/></sensor></mujoco>";
}

void read_scene(const std::string& plugin, const std::string& keys, const std::string& fields) {
  const CompiledScene scene = compile_scene(scene_with(plugin, keys, fields), {}, "input.xml");
  const OldFields old = old_fields(*scene.model);
  for (const char* geom : {"ball", "box"}) old_keys(*scene.model, old, geom);
  old_contact_keys(*scene.model, old, {});
  if (plugin == "taxel.contact")
    read_contact_config(*scene.model, 0);
  else
    read_sensor_config(*scene.model, 0);
}

void run(const std::string& input) {
  static const bool registered = (register_sensor_plugin(), true);
  const Keys keys = keys_of(input);
  for (const std::string plugin : {"taxel.contact", "taxel.sensor"})
    read_or_refuse([&] {
      read_scene(plugin, plugin == "taxel.contact" ? keys.contact : keys.sensor, keys.fields);
      return registered;
    });
}

const Registered kTarget("plugin", run);

}  // namespace
}  // namespace taxel::fuzz
