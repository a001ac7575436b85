#include "core/sim/plugin/plugin_table.h"

#include <cstring>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/sim/plugin/contact_forces.h"

namespace taxel {
namespace {

constexpr const char* kAttributes[] = {"layout", "geom", "others", "materials", "force", "output", "taxels"};

/// What stands behind one plugin_data entry. Aligned, so that a wrong pointer shows (see unseal).
struct alignas(64) Slot {
  HydroInstance sensor;
  ContactForceWorkspace work;             // used by the first applying instance, for all
  std::vector<HydroInstance*> instances;  // scratch
  std::size_t warnings_told = 0;
  Slot(const mjModel& m, int instance) : sensor(m, instance) {}
  Slot(const Slot& other) : sensor(other.sensor), warnings_told(other.warnings_told) {}
  Slot& operator=(const Slot&) = delete;
};

/// plugin_data holds the pointer mixed with the address of its mjData. A bitwise copy of an mjData (Python's pickle)
/// carries the entry of the original: read through another address it gives no aligned user-space pointer, and the
/// copy neither uses nor frees what is not its own.
std::uintptr_t seal_key(const mjData& d) {
  return mix64(reinterpret_cast<std::uintptr_t>(&d));
}
std::uintptr_t seal(const mjData& d, const Slot* slot) {
  return reinterpret_cast<std::uintptr_t>(slot) ^ seal_key(d);
}
Slot* unseal(const mjData& d, std::uintptr_t sealed) {
  const std::uintptr_t address = sealed ^ seal_key(d);
  const bool plausible = sealed != 0 && address != 0 && address % alignof(Slot) == 0 && address >> 48 == 0;
  return plausible ? reinterpret_cast<Slot*>(address) : nullptr;
}

bool is_ours(const mjData& d, int instance) {
  const mjpPlugin* plugin = mjp_getPluginAtSlot(d.plugin[instance]);
  return plugin != nullptr && std::strcmp(plugin->name, kPluginName) == 0;
}

Slot* find_slot(const mjData& d, int instance) {
  return is_ours(d, instance) ? unseal(d, d.plugin_data[instance]) : nullptr;
}

void warn(const mjModel& m, int instance, const std::string& message) {
  mju_warning("%s \"%s\": %s", kPluginName, instance_name(m, instance).c_str(), message.c_str());
}

/// Runs a callback's body: no exception may cross into MuJoCo. Returns whether it went well.
bool guarded(const mjModel& m, int instance, const std::function<void()>& body) {
  try {
    body();
    return true;
  } catch (const std::exception& error) {
    warn(m, instance, error.what());
  } catch (...) {
    warn(m, instance, "unknown failure");
  }
  return false;
}

int count_states(const mjModel* m, int instance) {
  const char* force = mj_getPluginConfig(m, instance, "force");
  return force != nullptr && std::strcmp(force, "sense") == 0 ? 0 : static_cast<int>(m->nv);
}

int count_sensor_values(const mjModel* m, int instance, int) {
  int count = 0;
  // What is wrong is told by init, which follows: MuJoCo makes that the compile error.
  try {
    count = sensor_dimension(*m, instance);
  } catch (...) {
    count = 0;
  }
  return count;
}

/// Makes the sensor of a new mjData, or of one that came as a bitwise copy.
Slot* make_slot(const mjModel& m, mjData& d, int instance) {
  auto slot = std::make_unique<Slot>(m, instance);
  for (int i = 0; i < instance; ++i) {  // those after it are not made yet, or know it when they are asked
    Slot* before = find_slot(d, i);
    if (before == nullptr) continue;
    slot->sensor.link(m, before->sensor);
    before->sensor.link(m, slot->sensor);
  }
  for (const std::string& text : slot->sensor.warnings()) warn(m, instance, text);
  slot->warnings_told = slot->sensor.warnings().size();
  d.plugin_data[instance] = seal(d, slot.get());
  return slot.release();
}

int init(const mjModel* m, mjData* d, int instance) {
  d->plugin_data[instance] = 0;
  return guarded(*m, instance, [&] { make_slot(*m, *d, instance); }) ? 0 : -1;
}

void destroy(mjData* d, int instance) {
  delete find_slot(*d, instance);
  d->plugin_data[instance] = 0;
}

void copy(mjData* dest, const mjModel* m, const mjData* src, int instance) {
  guarded(*m, instance, [&] {
    const Slot* from = find_slot(*src, instance);
    if (from == nullptr) {
      if (find_slot(*dest, instance) == nullptr) dest->plugin_data[instance] = 0;
      return;
    }
    auto made = std::make_unique<Slot>(*from);
    delete find_slot(*dest, instance);
    dest->plugin_data[instance] = seal(*dest, made.release());
  });
}

void reset(const mjModel* m, mjtNum* plugin_state, void* plugin_data, int instance) {
  if (plugin_state != nullptr)
    for (int i = 0; i < m->plugin_statenum[instance]; ++i) plugin_state[i] = 0;
  static_cast<void>(plugin_data);  // sealed; whatever state the sensor holds is checked against the poses when used
}

/// The slot of this mjData; a bitwise copy gets one of its own first.
Slot& own_slot(const mjModel& m, mjData& d, int instance) {
  Slot* slot = find_slot(d, instance);
  return slot != nullptr ? *slot : *make_slot(m, d, instance);
}

/// The first instance that applies forces does so for all.
bool leads(const mjModel& m, mjData& d, int instance) {
  for (int i = 0; i < instance; ++i)
    if (is_ours(d, i) && own_slot(m, d, i).sensor.config().apply) return false;
  return own_slot(m, d, instance).sensor.config().apply;
}

void compute_passive(const mjModel& m, mjData& d, int instance) {
  if (!leads(m, d, instance)) return;
  Slot& leader = own_slot(m, d, instance);
  leader.instances.clear();
  for (int i = instance; i < m.nplugin; ++i) {
    if (!is_ours(d, i)) continue;
    HydroInstance& sensor = own_slot(m, d, i).sensor;
    if (sensor.config().apply && sensor.model() != nullptr) leader.instances.push_back(&sensor);
  }
  const std::span<const mjtNum> late(d.plugin_state + m.plugin_stateadr[instance],
                                     static_cast<std::size_t>(m.plugin_statenum[instance]));
  apply_contact_forces(m, d, leader.instances, late, leader.work);
}

void compute(const mjModel* m, mjData* d, int instance, int capability) {
  Slot* slot = find_slot(*d, instance);
  if (slot != nullptr && !slot->sensor.failure.empty()) return;
  try {
    if (slot == nullptr) slot = make_slot(*m, *d, instance);
    if (capability == mjPLUGIN_PASSIVE) compute_passive(*m, *d, instance);
    if (capability == mjPLUGIN_SENSOR && slot->sensor.model() != nullptr) slot->sensor.sense(*m, *d);
    for (; slot->warnings_told < slot->sensor.warnings().size(); ++slot->warnings_told)
      warn(*m, instance, slot->sensor.warnings()[slot->warnings_told]);
  } catch (const std::exception& error) {
    warn(*m, instance, error.what());
    if (slot != nullptr) slot->sensor.failure = error.what();
  } catch (...) {
    warn(*m, instance, "unknown failure");
    if (slot != nullptr) slot->sensor.failure = "unknown failure";
  }
}

/// Remembers, as plugin state, the forces that the next PASSIVE stage needs before MuJoCo has computed them.
void advance(const mjModel* m, mjData* d, int instance) {
  mjtNum* state = d->plugin_state + m->plugin_stateadr[instance];
  for (int i = 0; i < m->plugin_statenum[instance]; ++i) state[i] = d->qfrc_constraint[i] + d->qfrc_actuator[i];
}

}  // namespace

bool register_sensor_plugin() {
  if (const mjpPlugin* present = mjp_getPlugin(kPluginName, nullptr)) return present->compute == compute;
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = kPluginName;
  plugin.nattribute = static_cast<int>(std::size(kAttributes));
  plugin.attributes = kAttributes;
  plugin.capabilityflags = mjPLUGIN_PASSIVE | mjPLUGIN_SENSOR;
  plugin.needstage = mjSTAGE_ACC;
  plugin.nstate = count_states;
  plugin.nsensordata = count_sensor_values;
  plugin.init = init;
  plugin.destroy = destroy;
  plugin.copy = copy;
  plugin.reset = reset;
  plugin.compute = compute;
  plugin.advance = advance;
  mjp_registerPlugin(&plugin);
  return true;
}

HydroInstance& own_sensor(const mjModel& m, mjData& d, int instance) {
  return own_slot(m, d, instance).sensor;
}

HydroInstance* find_sensor(const mjData& d, int instance) {
  Slot* slot = find_slot(d, instance);
  return slot != nullptr ? &slot->sensor : nullptr;
}

std::vector<int> sensor_instances(const mjModel& m) {
  std::vector<int> instances;
  for (int i = 0; i < m.nplugin; ++i) {
    const mjpPlugin* plugin = mjp_getPluginAtSlot(m.plugin[i]);
    if (plugin != nullptr && std::strcmp(plugin->name, kPluginName) == 0) instances.push_back(i);
  }
  return instances;
}

}  // namespace taxel
