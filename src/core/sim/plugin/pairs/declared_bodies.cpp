#include "core/sim/plugin/pairs/declared_bodies.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {
namespace {

/// Returns the body that represents a geom, or null if there is none.
const DeclaredBody* body_on(const std::vector<DeclaredBody>& bodies, int geom) {
  const DeclaredBody* found = nullptr;
  for (const DeclaredBody& body : bodies) {
    if (body.settings.geom != geom) continue;
    if (found == nullptr || (body.settings.apply && !found->settings.apply)) found = &body;
  }
  return found;
}

/// Returns true if `a` computes the pair. The order is by name, so neither the order of the bodies in the model nor
/// that of the instances changes a bit of the result.
bool computes_before(const ContactSettings& a, const ContactSettings& b) {
  return a.apply != b.apply ? a.apply : a.geom_name < b.geom_name;
}

void add_other(ContactSettings& settings, int geom) {
  if (geom == settings.geom) return;
  const auto place = std::lower_bound(settings.others.begin(), settings.others.end(), geom);
  if (place == settings.others.end() || *place != geom) settings.others.insert(place, geom);
}

/// A `taxel.contact` with the number of its instance.
struct DeclaredContact {
  int instance = -1;
  ContactConfig config;
};

/// All sensors and contacts that a model declares.
struct Declared {
  std::vector<DeclaredBody> bodies;
  std::vector<DeclaredContact> contacts;
};

Declared read_all(const mjModel& m, int instance) {
  Declared all;
  const auto read = [&](int i, const auto& action) {
    try {
      action();
    } catch (const Error&) {
      if (i == instance) throw;
    }
  };
  for (const int i : sensor_instances(m)) {
    read(i, [&] { all.bodies.push_back({{i, 0}, true, read_sensor_config(m, i)}); });
  }
  for (const int i : contact_instances(m)) {
    read(i, [&] {
      const ContactConfig config = read_contact_config(m, i);
      for (std::size_t k = 0; k < config.bodies.size(); ++k)
        all.bodies.push_back({{i, static_cast<int>(k)}, false, config.bodies[k]});
      all.contacts.push_back({i, config});
    });
  }
  std::sort(all.bodies.begin(), all.bodies.end(),
            [](const DeclaredBody& a, const DeclaredBody& b) { return a.id < b.id; });
  return all;
}

/// Throws Error if `instance` and another one disagree on a geom's material.
void check_materials(const Declared& all, int instance) {
  for (const DeclaredContact& contact : all.contacts) {
    for (const auto& [name, material] : contact.config.materials) {
      for (const DeclaredContact& other : all.contacts) {
        if (other.instance >= contact.instance || (other.instance != instance && contact.instance != instance))
          continue;
        const auto theirs = other.config.materials.find(name);
        if (theirs == other.config.materials.end()) continue;
        if (material.material.compliant() || !(theirs->second == material))
          throw Error("", "materials",
                      fmt::format("geom \"{}\" has two materials, of \"{}\" and \"{}\": a geom takes one", name,
                                  other.config.name, contact.config.name));
      }
      for (const DeclaredBody& body : all.bodies) {
        if (!body.sensor || (body.id.instance != instance && contact.instance != instance)) continue;
        const auto theirs = body.settings.materials.find(name);
        if (theirs != body.settings.materials.end() && !(theirs->second == material))
          throw Error(
              "", "materials",
              fmt::format("geom \"{}\" has two materials, of sensor \"{}\" and contact \"{}\": a geom takes one", name,
                          body.settings.name, contact.config.name));
      }
    }
  }
}

/// Moves the pairs that a contact names with the geom of a sensor to the sensor, which computes them.
void give_pairs_to_sensors(const mjModel& m, Declared& all, int instance) {
  for (const DeclaredContact& contact : all.contacts) {
    for (const auto& [a, b] : contact.config.pairs) {
      for (DeclaredBody& body : all.bodies) {
        ContactSettings& settings = body.settings;
        if (!body.sensor || (settings.geom != a && settings.geom != b)) continue;
        if (settings.apply != contact.config.apply && (contact.instance == instance || body.id.instance == instance))
          throw Error("", "force",
                      fmt::format("sensor \"{}\" and contact \"{}\" share the pair \"{}\" and \"{}\": both must apply "
                                  "its force, or both sense it",
                                  settings.name, contact.config.name, m.names + m.name_geomadr[a],
                                  m.names + m.name_geomadr[b]));
        add_other(settings, settings.geom == a ? b : a);
      }
    }
  }
}

/// Adds each named pair to both of its bodies, and each material that a contact gives to a geom to all bodies.
void complete_settings(Declared& all) {
  for (const DeclaredContact& contact : all.contacts)
    for (DeclaredBody& body : all.bodies)
      body.settings.materials.insert(contact.config.materials.begin(), contact.config.materials.end());
  for (const DeclaredBody& body : all.bodies)
    for (DeclaredBody& other : all.bodies)
      if (std::binary_search(body.settings.others.begin(), body.settings.others.end(), other.settings.geom))
        add_other(other.settings, body.settings.geom);
}

}  // namespace

std::vector<DeclaredBody> declared_bodies(const mjModel& m, int instance) {
  Declared all = read_all(m, instance);
  check_materials(all, instance);
  give_pairs_to_sensors(m, all, instance);
  complete_settings(all);
  return std::move(all.bodies);
}

PairRole pair_role(const std::vector<DeclaredBody>& bodies, const DeclaredBody& self, int geom) {
  const DeclaredBody* other = body_on(bodies, geom);
  if (other == nullptr) return {{}, false, self.settings.apply};
  if (body_on(bodies, self.settings.geom)->id != self.id) return {other->id, false, false};
  return {other->id, computes_before(other->settings, self.settings), self.settings.apply || other->settings.apply};
}

}  // namespace taxel
