#include "core/sim/plugin/plugin_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"

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

namespace {

int geom_named(const mjModel& m, const std::string& name) {
  for (int g = 0; g < m.ngeom; ++g)
    if (name == m.names + m.name_geomadr[g]) return g;
  return -1;
}

/// Returns the geom to which the first entry of an instance under `<sensor>` refers, or -1.
int referred_geom(const mjModel& m, int instance) {
  for (int s = 0; s < m.nsensor; ++s)
    if (m.sensor_type[s] == mjSENS_PLUGIN && m.sensor_plugin[s] == instance && m.sensor_objtype[s] == mjOBJ_GEOM)
      return m.sensor_objid[s];
  return -1;
}

/// Returns the length of the ending that a name shares with the names of all entries of an instance under `<sensor>`. A
/// suffix is behind each of them.
std::size_t shared_ending(const mjModel& m, int instance, const std::string& name) {
  std::size_t length = name.size();
  for (int s = 0; s < m.nsensor; ++s) {
    const std::string entry = m.names + m.name_sensoradr[s];
    if (m.sensor_type[s] != mjSENS_PLUGIN || m.sensor_plugin[s] != instance || entry.empty()) continue;
    const auto differ = std::mismatch(name.rbegin(), name.rend(), entry.rbegin(), entry.rend());
    length = std::min(length, static_cast<std::size_t>(differ.first - name.rbegin()));
  }
  return length;
}

/// Adds the texts that may have been put around a name: its beginnings, then its endings of at most `ending`
/// characters, the longest first, then both at once.
void add_possible_affixes(const std::string& name, std::size_t ending, std::vector<Affixes>& affixes) {
  const std::size_t size = name.size();
  for (std::size_t length = size; length > 0; --length) affixes.push_back({name.substr(0, length), ""});
  for (std::size_t length = ending; length > 0; --length) affixes.push_back({"", name.substr(size - length)});
  for (std::size_t before = size; before > 0; --before)
    for (std::size_t after = std::min(ending, size - before); after > 0; --after)
      affixes.push_back({name.substr(0, before), name.substr(size - after)});
}

/// Returns the texts around `inner` in `whole`, for each of its places: a prefix alone first, then a suffix alone.
std::vector<Affixes> affixes_around(const std::string& inner, const std::string& whole) {
  std::vector<Affixes> affixes;
  for (std::size_t place = whole.find(inner); place != std::string::npos; place = whole.find(inner, place + 1))
    affixes.push_back({whole.substr(0, place), whole.substr(place + inner.size())});
  const auto rank = [](const Affixes& one) { return one.suffix.empty() ? 0 : one.prefix.empty() ? 1 : 2; };
  std::stable_sort(affixes.begin(), affixes.end(),
                   [&](const Affixes& a, const Affixes& b) { return rank(a) < rank(b); });
  return affixes;
}

/// Returns the name of the first geom that is a copy of `name`, which `<replicate>` numbers, or an empty text.
std::string numbered_copy(const mjModel& m, const std::string& name) {
  for (int g = 0; g < m.ngeom; ++g) {
    const std::string present = m.names + m.name_geomadr[g];
    if (present.size() > name.size() && present.starts_with(name) &&
        present.find_first_not_of("0123456789", name.size()) == std::string::npos)
      return present;
  }
  return "";
}

/// Returns true if the model looks like one that `<compiler discardvisual="true"/>` has left.
bool has_nothing_visual(const mjModel& m) {
  for (int g = 0; g < m.ngeom; ++g)
    if (!can_collide(m, g)) return false;
  return m.nmat == 0 && m.ntex == 0;
}

/// Returns the likely reason for which no name finds a geom, with the remedy, or an empty text.
std::string reason_for_absence(const mjModel& m, const std::string& name) {
  for (int f = 0; f < m.nflex; ++f)
    if (name == m.names + m.name_flexadr[f])
      return "; it is a flex, and taxels need a geom with the mesh of their layout: give a rigid body that mesh";
  const std::string reference = fmt::format("objtype=\"geom\" objname=\"{}\"", name);
  if (const std::string copy = numbered_copy(m, name); !copy.empty())
    return fmt::format(
        "; there is \"{}\", as <replicate> names its copies: each copy gets its own sensor if the entry under "
        "<sensor> refers to the geom ({})",
        copy, reference);
  if (has_nothing_visual(m))
    return fmt::format(
        "; if <compiler discardvisual=\"true\"/> has removed it because it cannot collide, leave that out, or, for the "
        "geom of a sensor, let the entry under <sensor> refer to it ({})",
        reference);
  return "";
}

}  // namespace

std::string config_value(const mjModel& m, int instance, const char* key) {
  const char* value = mj_getPluginConfig(&m, instance, key);
  return value != nullptr ? value : "";
}

std::string instance_name(const mjModel& m, int instance) {
  const char* name = m.names + m.name_pluginadr[instance];
  for (int s = 0; *name == '\0' && s < m.nsensor; ++s)
    if (m.sensor_type[s] == mjSENS_PLUGIN && m.sensor_plugin[s] == instance) name = m.names + m.name_sensoradr[s];
  return *name != '\0' ? name : fmt::format("#{}", instance);
}

GeomNames::GeomNames(const mjModel& m, int instance)
    : m_(m), geom_(config_value(m, instance, "geom")), referred_(referred_geom(m, instance)) {
  const std::string present = referred_ >= 0 ? m.names + m.name_geomadr[referred_] : "";
  if (!geom_.empty() && present.find(geom_) != std::string::npos) {
    if (present != geom_) affixes_ = affixes_around(geom_, present);
    return;
  }
  for (const std::string& name : {std::string(m.names + m.name_pluginadr[instance]), present})
    add_possible_affixes(name, shared_ending(m, instance, name), affixes_);
}

int GeomNames::find_or_none(const std::string& name) const {
  int geom = geom_named(m_, name);
  for (std::size_t i = 0; geom < 0 && i < affixes_.size(); ++i)
    geom = geom_named(m_, affixes_[i].prefix + name + affixes_[i].suffix);
  return geom;
}

int GeomNames::find(const std::string& name, const char* key) const {
  const int geom = find_or_none(name);
  if (geom >= 0) return geom;
  std::string second;
  if (affixes_.size() == 1 && referred_ >= 0)
    second = fmt::format(" or \"{}{}{}\"", affixes_.front().prefix, name, affixes_.front().suffix);
  throw Error("", key, fmt::format("there is no geom named \"{}\"{}{}", name, second, reason_for_absence(m_, name)));
}

int GeomNames::sensor_geom() const {
  if (referred_ < 0) return geom_.empty() ? -1 : find(geom_, "geom");
  const std::string present = m_.names + m_.name_geomadr[referred_];
  if (!geom_.empty() && present.find(geom_) == std::string::npos)
    throw Error("", "geom",
                fmt::format("is \"{}\", but the entry under <sensor> refers to the geom \"{}\": leave out the key",
                            geom_, present));
  return referred_;
}

}  // namespace taxel
