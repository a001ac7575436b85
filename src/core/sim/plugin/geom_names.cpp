#include "core/sim/plugin/geom_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace taxel {
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

void add_beginnings(const std::string& name, std::vector<std::string>& prefixes) {
  for (std::size_t length = name.size(); length > 0; --length) prefixes.push_back(name.substr(0, length));
}

}  // namespace

std::string config_value(const mjModel& m, int instance, const char* key) {
  const char* value = mj_getPluginConfig(&m, instance, key);
  return value != nullptr ? value : "";
}

std::string instance_name(const mjModel& m, int instance) {
  const char* name = m.names + m.name_pluginadr[instance];
  return *name != '\0' ? name : fmt::format("#{}", instance);
}

GeomNames::GeomNames(const mjModel& m, int instance)
    : m_(m), geom_(config_value(m, instance, "geom")), referred_(referred_geom(m, instance)) {
  const std::string present = referred_ >= 0 ? m.names + m.name_geomadr[referred_] : "";
  if (!geom_.empty() && present.ends_with(geom_)) {
    if (present != geom_) prefixes_.push_back(present.substr(0, present.size() - geom_.size()));
    return;
  }
  add_beginnings(m.names + m.name_pluginadr[instance], prefixes_);
  add_beginnings(present, prefixes_);
}

int GeomNames::find_or_none(const std::string& name) const {
  int geom = geom_named(m_, name);
  for (std::size_t i = 0; geom < 0 && i < prefixes_.size(); ++i) geom = geom_named(m_, prefixes_[i] + name);
  return geom;
}

int GeomNames::find(const std::string& name, const char* key) const {
  const int geom = find_or_none(name);
  if (geom >= 0) return geom;
  const bool prefix_known = prefixes_.size() == 1 && referred_ >= 0;
  throw Error("", key,
              fmt::format("there is no geom named \"{}\"{}", name,
                          prefix_known ? fmt::format(" or \"{}{}\"", prefixes_.front(), name) : ""));
}

int GeomNames::sensor_geom() const {
  if (referred_ < 0) return geom_.empty() ? -1 : find(geom_, "geom");
  const std::string present = m_.names + m_.name_geomadr[referred_];
  if (!geom_.empty() && !present.ends_with(geom_))
    throw Error("", "geom",
                fmt::format("is \"{}\", but the entry under <sensor> refers to the geom \"{}\": leave out the key",
                            geom_, present));
  return referred_;
}

}  // namespace taxel
