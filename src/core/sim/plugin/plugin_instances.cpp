#include "core/sim/plugin/plugin_instances.h"

#include <cstring>

namespace taxel {
namespace {

std::vector<int> instances_of(const mjModel& m, const char* name) {
  std::vector<int> instances;
  for (int i = 0; i < m.nplugin; ++i)
    if (is_plugin(m.plugin[i], name)) instances.push_back(i);
  return instances;
}

}  // namespace

bool is_plugin(int slot, const char* name) {
  const mjpPlugin* plugin = mjp_getPluginAtSlot(slot);
  return plugin != nullptr && std::strcmp(plugin->name, name) == 0;
}

std::vector<int> sensor_instances(const mjModel& m) {
  return instances_of(m, kPluginName);
}

std::vector<int> contact_instances(const mjModel& m) {
  return instances_of(m, kContactPluginName);
}

}  // namespace taxel
