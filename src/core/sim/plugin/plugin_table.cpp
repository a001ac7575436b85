#include "core/sim/plugin/plugin_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/text/message.h"
#include "core/sim/plugin/drawn_contacts.h"
#include "core/sim/plugin/forces/contact_forces.h"
#include "core/sim/plugin/forces/stiff_servos.h"
#include "core/sim/plugin/pairs/pair_warnings.h"
#include "core/sim/plugin/shared/owned_objects.h"

namespace taxel {
namespace {

/// The instance of one plugin_data entry: a sensor or a contact.
struct Slot {
  std::optional<HydroInstance> sensor;
  std::optional<ContactInstance> contact;
  ContactForceWorkspace work;                  // used only in the first instance that applies forces
  std::vector<BodyContacts*> bodies_of_all;    // scratch memory
  std::vector<HydroInstance*> unread;          // scratch memory
  std::vector<std::size_t> reported_warnings;  // number of reported warnings of each body
  CompiledSensors compiled;                    // until the first step; only in the first sensor of an mjData
  Slot(const mjModel& m, int instance) {
    if (is_plugin(m.plugin[instance], kContactPluginName)) {
      contact.emplace(m, instance);
    } else {
      sensor.emplace(m, instance);
    }
    reported_warnings.resize(bodies().size());
  }
  Slot(const Slot& other) : sensor(other.sensor), contact(other.contact), reported_warnings(other.reported_warnings) {
    for (BodyContacts& body : bodies()) body.times = {};
  }
  Slot& operator=(const Slot&) = delete;

  std::span<BodyContacts> bodies() {
    if (sensor) return {&sensor->contacts(), 1};
    return contact->bodies();
  }
  [[nodiscard]] bool applies() const { return sensor ? sensor->config().apply : contact->config().apply; }
};

/// Returns the slots of all mjData. An entry of plugin_data is a number of this table. A bitwise copy of an mjData (as
/// Python's pickle makes) has the numbers of the original, which are not valid for the copy, even if the copy comes to
/// the address of an original that was freed. The table is never destroyed, because Python frees data at its very end.
OwnedObjects& slots() {
  static OwnedObjects* const all = new OwnedObjects;
  return *all;
}

bool is_ours(const mjData& d, int instance) {
  return is_plugin(d.plugin[instance], kPluginName) || is_plugin(d.plugin[instance], kContactPluginName);
}

Slot* find_slot(const mjData& d, int instance) {
  return is_ours(d, instance) ? static_cast<Slot*>(slots().find(&d, d.plugin_data[instance])) : nullptr;
}

/// Replaces the slot of an mjData and frees the previous one.
void set_slot(mjData& d, int instance, std::unique_ptr<Slot> slot) {
  const std::unique_ptr<Slot> previous(static_cast<Slot*>(slots().remove(&d, d.plugin_data[instance])));
  d.plugin_data[instance] = slot == nullptr ? 0 : slots().add(&d, slot.get());
  static_cast<void>(slot.release());  // the table has it
}

/// Returns the message of an instance.
std::string message_of(const mjModel& m, int instance, const std::string& reason) {
  return fmt::format("{} \"{}\": {}", mjp_getPluginAtSlot(m.plugin[instance])->name, instance_name(m, instance),
                     reason);
}

void warn(const mjModel& m, int instance, const std::string& message) {
  mju_warning("%s", message_of(m, instance, message).c_str());
}

bool (*do_warnings_wait)() = nullptr;

bool warnings_wait() {
  return do_warnings_wait != nullptr && do_warnings_wait();
}

/// Reports the warnings that were added since the last call.
void warn_of_new(const mjModel& m, int instance, Slot& slot) {
  if (warnings_wait()) return;
  for (std::size_t k = 0; k < slot.bodies().size(); ++k) {
    const std::vector<std::string>& warnings = slot.bodies()[k].warnings;
    for (std::size_t& n = slot.reported_warnings[k]; n < warnings.size(); ++n) warn(m, instance, warnings[n]);
  }
}

/// Runs the body of a callback and catches its exceptions, since no exception may reach MuJoCo. Returns true on
/// success.
template <class Body>
bool guarded(const mjModel& m, int instance, const Body& body) {
  try {
    body();
    return true;
  } catch (const std::exception& error) {
    warn(m, instance, shown_message(error));
  } catch (...) {
    warn(m, instance, "unknown failure");
  }
  return false;
}

/// Returns the number of state values that the forces of the previous step take.
int count_late_forces(const mjModel& m, int instance) {
  const char* force = mj_getPluginConfig(&m, instance, "force");
  return force != nullptr && std::strcmp(force, "sense") == 0 ? 0 : static_cast<int>(m.nv);
}

/// The state of an instance has the forces of the previous step if the instance applies forces, then the bristles of
/// each body, then the chain of the taxels if its values are in the output.
int count_states(const mjModel* m, int instance) {
  int count = count_late_forces(*m, instance);
  // An error is ignored here: `init` reports it as the compile error.
  try {
    const bool contact = is_plugin(m->plugin[instance], kContactPluginName);
    const BristleSettings bristles = contact ? read_bristles(*m, instance) : sensor_bristles(*m, instance);
    if (!contact) count += chain_state_size(*m, instance);
    if (!bristles.has_bristles()) return count;
    const int bodies = contact ? static_cast<int>(read_contact_config(*m, instance).bodies.size()) : 1;
    count += bodies * bristle_state_size(bristles, static_cast<int>(m->ngeom));
  } catch (...) {
    return count;
  }
  return count;
}

int count_sensor_values(const mjModel* m, int instance, int) {
  int count = 0;
  // An error is ignored here: `init` is called next, and MuJoCo reports its error as the compile error.
  try {
    const bool contact = is_plugin(m->plugin[instance], kContactPluginName);
    count = contact ? contact_dimension(*m, instance) : sensor_dimension(*m, instance);
  } catch (...) {
    count = 0;
  }
  return count;
}

/// Returns true if no earlier instance applies forces.
bool is_first_that_applies(const mjModel& m, const mjData& d, int instance) {
  for (int i = 0; i < instance && i < m.nplugin; ++i)
    if (const Slot* before = find_slot(d, i); before != nullptr && before->applies()) return false;
  return true;
}

/// Returns true for the first of several sensors.
bool is_first_of_sensors(const mjModel& m, int instance) {
  const std::vector<int> sensors = sensor_instances(m);
  return sensors.size() > 1 && sensors.front() == instance;
}

/// Builds the instance for a new mjData, or for one that is a bitwise copy.
Slot* make_slot(const mjModel& m, mjData& d, int instance) {
  CompiledSensors compiled;
  if (is_first_of_sensors(m, instance)) compiled = compile_side_by_side(m);
  auto slot = std::make_unique<Slot>(m, instance);
  slot->compiled = std::move(compiled);
  const std::span<BodyContacts> bodies = slot->bodies();
  const auto link_both = [&](BodyContacts& a, BodyContacts& b) {
    a.link(b);
    b.link(a);
  };
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) link_both(bodies[i], bodies[j]);
  for (int i = 0; i < instance; ++i) {  // later instances are built later, and then find this one
    Slot* before = find_slot(d, i);
    if (before == nullptr) continue;
    for (BodyContacts& body : bodies)
      for (BodyContacts& other : before->bodies()) link_both(body, other);
  }
  if (slot->applies() && !bodies.empty() && is_first_that_applies(m, d, instance))
    for (std::string& warning : stiff_servo_warnings(m)) bodies[0].warnings.push_back(std::move(warning));
  for (const BodyContacts& body : bodies)
    for (const TouchedGeom& touched : body.touched())
      if (!touched.repair.empty() && !warnings_wait()) warn(m, instance, touched.repair);
  warn_of_new(m, instance, *slot);
  set_slot(d, instance, std::move(slot));
  return find_slot(d, instance);
}

/// Builds the instance for a new mjData. Returns true on success, and otherwise writes the message.
bool try_to_make_slot(const mjModel& m, mjData& d, int instance, std::span<char> message) {
  const auto write = [&](const std::string& reason) {
    const auto end = fmt::format_to_n(message.data(), message.size() - 1, "{}", message_of(m, instance, reason));
    *end.out = '\0';
  };
  try {
    make_slot(m, d, instance);
    return true;
  } catch (const std::exception& error) {
    write(shown_message(error));
  } catch (...) {
    write("unknown failure");
  }
  return false;
}

/// A failure is MuJoCo's error, and not a warning and the result -1: MuJoCo prints warnings of a compilation twice. The
/// error leaves this function by a jump, so no object with a destructor may be alive. The mjData, of which nobody else
/// has a pointer yet, is freed first with the instances before this one, as MuJoCo frees it on -1.
int init(const mjModel* m, mjData* d, int instance) {
  d->plugin_data[instance] = 0;
  std::array<char, 1000> message;
  if (try_to_make_slot(*m, *d, instance, message)) return 0;
  d->nplugin = instance;
  mj_deleteData(d);
  mju_error("%s", message.data());
  return -1;
}

void destroy(mjData* d, int instance) {
  set_slot(*d, instance, nullptr);
}

void copy(mjData* dest, const mjModel* m, const mjData* src, int instance) {
  guarded(*m, instance, [&] {
    const Slot* from = find_slot(*src, instance);
    if (from == nullptr) {
      if (find_slot(*dest, instance) == nullptr) dest->plugin_data[instance] = 0;
      return;
    }
    set_slot(*dest, instance, std::make_unique<Slot>(*from));
  });
}

void reset(const mjModel* m, mjtNum* plugin_state, void* plugin_data, int instance) {
  if (plugin_state != nullptr)
    for (int i = 0; i < m->plugin_statenum[instance]; ++i) plugin_state[i] = 0;
  static_cast<void>(
      plugin_data);  // a number of slots(); the state of the sensor is checked against the poses at its next use
}

/// Returns the slot of this mjData, and builds it first if `d` is a bitwise copy.
Slot& own_slot(const mjModel& m, mjData& d, int instance) {
  Slot* slot = find_slot(d, instance);
  return slot != nullptr ? *slot : *make_slot(m, d, instance);
}

/// Returns true for the first instance that applies forces. It applies the forces of all instances.
bool leads(const mjModel& m, mjData& d, int instance) {
  for (int i = 0; i < instance; ++i)
    if (is_ours(d, i) && own_slot(m, d, i).applies()) return false;
  return own_slot(m, d, instance).applies();
}

void compute_passive(const mjModel& m, mjData& d, int instance) {
  if (!leads(m, d, instance)) return;
  Slot& leader = own_slot(m, d, instance);
  leader.bodies_of_all.clear();
  for (int i = instance; i < m.nplugin; ++i) {
    if (!is_ours(d, i)) continue;
    for (BodyContacts& body : own_slot(m, d, i).bodies())
      if (body.settings().apply && body.body() != nullptr) leader.bodies_of_all.push_back(&body);
  }
  const std::span<const mjtNum> late(d.plugin_state + m.plugin_stateadr[instance],
                                     static_cast<std::size_t>(count_late_forces(m, instance)));
  apply_contact_forces(m, d, leader.bodies_of_all, late, leader.work);
}

void fail(const mjModel& m, int instance, Slot* slot, const std::string& reason) {
  warn(m, instance, reason);
  if (slot == nullptr) return;
  for (BodyContacts& body : slot->bodies()) body.failure = reason;
}

void sense(const mjModel& m, mjData& d, Slot& slot) {
  if (slot.contact) slot.contact->sense(m, d);
  if (slot.sensor && slot.sensor->model() != nullptr) slot.sensor->sense(m, d);
}

/// Returns true for the last of our instances, which reads the sensors of all, so that they can be read side by side:
/// MuJoCo calls instances one after another, and looks at sensordata only after the last one.
bool reads_for_all(const mjModel& m, const mjData& d, int instance) {
  for (int i = instance + 1; i < m.nplugin; ++i)
    if (is_ours(d, i)) return false;
  return true;
}

void read_all(const mjModel& m, mjData& d, std::vector<HydroInstance*>& unread) {
  unread.clear();
  for (int i = 0; i < m.nplugin; ++i) {
    Slot* slot = find_slot(d, i);
    if (slot == nullptr || !slot->sensor || !slot->sensor->contacts().failure.empty()) continue;
    if (slot->sensor->is_unread() && !slot->sensor->defers()) unread.push_back(&*slot->sensor);
  }
  read_sensors(m, d, unread);
  for (HydroInstance* sensor : unread) {
    const BodyContacts& body = sensor->contacts();
    if (!body.failure.empty()) warn(m, body.id().instance, body.failure);
  }
}

bool has_failed(Slot& slot) {
  return !slot.bodies().empty() && !slot.bodies()[0].failure.empty();
}

/// Computes what MuJoCo asks of one instance.
void compute_one(const mjModel* m, mjData* d, int instance, int capability) {
  Slot* slot = find_slot(*d, instance);
  if (slot != nullptr && has_failed(*slot)) return;
  try {
    if (slot == nullptr) slot = make_slot(*m, *d, instance);
    slot->compiled = {};
    if (capability == mjPLUGIN_PASSIVE) compute_passive(*m, *d, instance);
    if (capability == mjPLUGIN_SENSOR) sense(*m, *d, *slot);
    warn_of_new(*m, instance, *slot);
  } catch (const std::exception& error) {
    fail(*m, instance, slot, shown_message(error));
  } catch (...) {
    fail(*m, instance, slot, "unknown failure");
  }
}

void compute(const mjModel* m, mjData* d, int instance, int capability) {
  compute_one(m, d, instance, capability);
  Slot* slot = find_slot(*d, instance);
  if (capability == mjPLUGIN_SENSOR && slot != nullptr && reads_for_all(*m, *d, instance))
    guarded(*m, instance, [&] { read_all(*m, *d, slot->unread); });
}

/// Saves the forces of this step as plugin state, because the next PASSIVE stage needs them before MuJoCo computes
/// them, the state of the bristles, and that of the taxels' chain.
void advance(const mjModel* m, mjData* d, int instance) {
  mjtNum* state = d->plugin_state + m->plugin_stateadr[instance];
  const int late = count_late_forces(*m, instance);
  const bool knows_actuators = late > 0 && has_stiff_servos(*m);
  for (int i = 0; i < late; ++i) state[i] = d->qfrc_constraint[i] + (knows_actuators ? 0 : d->qfrc_actuator[i]);
  if (m->plugin_statenum[instance] == late) return;
  guarded(*m, instance, [&] {
    Slot& slot = own_slot(*m, *d, instance);
    for (BodyContacts& body : slot.bodies()) advance_bristles(*m, *d, body);
    if (slot.sensor) slot.sensor->advance(*m, *d);
  });
}

/// Draws the contacts of an instance. The pressure scale is that of all instances together.
void visualize(const mjModel* m, mjData* d, const mjvOption* options, mjvScene* scene, int instance) {
  if (options->flags[mjVIS_CONTACTPOINT] == 0 && options->flags[mjVIS_CONTACTFORCE] == 0) return;
  guarded(*m, instance, [&] {
    double full_scale = 0;
    for (int i = 0; i < m->nplugin; ++i) {
      if (!is_ours(*d, i)) continue;
      const bool is_bitwise_copy = find_slot(*d, i) == nullptr;
      for (BodyContacts& body : own_slot(*m, *d, i).bodies()) {
        if (is_bitwise_copy && body.body() != nullptr) sense_and_warn(*m, *d, body);
        full_scale = std::max(full_scale, largest_pressure(body));
      }
    }
    for (const BodyContacts& body : own_slot(*m, *d, instance).bodies())
      draw_contacts(*m, body, full_scale, *options, *scene);
  });
}

void register_plugin(const char* name, std::span<const char* const> keys) {
  mjpPlugin plugin;
  mjp_defaultPlugin(&plugin);
  plugin.name = name;
  plugin.nattribute = static_cast<int>(keys.size());
  plugin.attributes = keys.data();
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
  plugin.visualize = visualize;
  mjp_registerPlugin(&plugin);
}

}  // namespace

bool register_sensor_plugin() {
  if (const mjpPlugin* present = mjp_getPlugin(kPluginName, nullptr)) return present->compute == compute;
  register_plugin(kPluginName, kSensorKeys);
  register_plugin(kContactPluginName, kContactKeys);
  return true;
}

void delay_warnings_while(bool (*waits)()) {
  do_warnings_wait = waits;
}

HydroInstance* find_sensor(const mjData& d, int instance) {
  Slot* slot = find_slot(d, instance);
  return slot != nullptr && slot->sensor ? &*slot->sensor : nullptr;
}

BodyContacts& own_body(const mjModel& m, mjData& d, BodyId id) {
  return own_slot(m, d, id.instance).bodies()[static_cast<std::size_t>(id.number)];
}

BodyContacts* find_body(const mjData& d, BodyId id) {
  Slot* slot = find_slot(d, id.instance);
  return slot != nullptr ? &slot->bodies()[static_cast<std::size_t>(id.number)] : nullptr;
}

}  // namespace taxel
