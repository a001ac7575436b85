#include "core/sim/plugin/contact_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_instances.h"

namespace taxel {
namespace {

using GeomPair = std::pair<int, int>;

GeomPair ordered(int a, int b) {
  return a < b ? GeomPair{a, b} : GeomPair{b, a};
}

/// Returns the geoms that have a sensor of the model. They are soft or rigid, as their layout says.
std::vector<int> geoms_with_sensor(const mjModel& m) {
  std::vector<int> geoms;
  for (const int i : sensor_instances(m)) {
    try {
      if (const int geom = GeomNames(m, i).sensor_geom(); geom >= 0) geoms.push_back(geom);
    } catch (const Error&) {  // the sensor's own init reports the reason
    }
  }
  return geoms;
}

std::vector<int> soft_geoms(const GeomNames& names, const OtherMaterials& materials) {
  std::vector<int> soft;
  for (const auto& [name, material] : materials)
    if (material.material.compliant()) soft.push_back(names.find(name, "materials"));
  std::sort(soft.begin(), soft.end());
  return soft;
}

bool contains(const std::vector<int>& geoms, int geom) {
  return std::find(geoms.begin(), geoms.end(), geom) != geoms.end();
}

/// Reads pairs of geoms such as "ball floor, ball box".
std::vector<GeomPair> read_pairs(const GeomNames& geoms, const std::string& value, const std::vector<int>& soft) {
  std::vector<GeomPair> pairs;
  std::istringstream list(value);
  for (std::string item; std::getline(list, item, ',');) {
    const std::vector<std::string> names = split_words(item);
    if (names.size() != 2)
      throw Error("", "pairs", fmt::format("must be pairs of geom names with a comma between pairs, has \"{}\"", item));
    const int a = geoms.find(names[0], "pairs"), b = geoms.find(names[1], "pairs");
    if (a == b) throw Error("", "pairs", fmt::format("\"{}\" is paired with itself", names[0]));
    if (!contains(soft, a) && !contains(soft, b))
      throw Error("", "pairs",
                  fmt::format("\"{}\" and \"{}\" are both rigid: \"materials\" must give one of them a modulus above 0",
                              names[0], names[1]));
    const GeomPair pair = ordered(a, b);
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  return pairs;
}

/// Returns all pairs of the named geoms that are on different bodies and of which at least one is soft.
std::vector<GeomPair> read_geoms(const mjModel& m, const GeomNames& names, const std::string& value,
                                 const std::vector<int>& soft) {
  std::vector<int> geoms;
  for (const std::string& name : split_words(value)) {
    const int g = names.find(name, "geoms");
    if (!contains(geoms, g)) geoms.push_back(g);
  }
  std::vector<GeomPair> pairs;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int a = geoms[i], b = geoms[j];
      const bool apart = m.geom_bodyid[a] != m.geom_bodyid[b];
      if (apart && (contains(soft, a) || contains(soft, b))) pairs.push_back(ordered(a, b));
    }
  }
  if (pairs.empty())
    throw Error("", "geoms", fmt::format("names no two geoms on different bodies of which one is soft: \"{}\"", value));
  return pairs;
}

std::vector<int> partners(const mjModel& m, const ContactConfig& config, bool named, int geom) {
  std::vector<int> others;
  for (int g = 0; g < m.ngeom; ++g) {
    if (g == geom) continue;
    const bool paired = std::binary_search(config.pairs.begin(), config.pairs.end(), ordered(geom, g));
    if (named ? paired : would_collide(m, geom, g)) others.push_back(g);
  }
  return others;
}

}  // namespace

ContactConfig read_contact_config(const mjModel& m, int instance) {
  ContactConfig config;
  config.name = instance_name(m, instance);
  config.materials = read_materials(m, instance);
  if (config.materials.empty())
    throw Error("", "materials", "is required: JSON with the material of each soft geom, by the geom's name");
  config.apply = read_force(m, instance);
  config.bristles = read_bristles(m, instance);
  config.output =
      read_output(config_value(m, instance, "output"), {Output::wrench, Output::elastic_wrench, Output::area});
  if (config.materials.contains(kAllGeoms))
    throw Error("", "materials", "\"*\" is only for sensors: name each soft geom");
  const GeomNames names(m, instance);
  const std::vector<int> soft = soft_geoms(names, config.materials), sensing = geoms_with_sensor(m);
  if (soft.empty()) throw Error("", "materials", "names no soft geom: one must have a modulus above 0");
  std::vector<int> can_be_pressed = soft;
  can_be_pressed.insert(can_be_pressed.end(), sensing.begin(), sensing.end());
  const std::string pairs = config_value(m, instance, "pairs"), geoms = config_value(m, instance, "geoms");
  if (!pairs.empty() && !geoms.empty()) throw Error("", "pairs", "excludes \"geoms\": give one of the two");
  if (!pairs.empty()) config.pairs = read_pairs(names, pairs, can_be_pressed);
  if (!geoms.empty()) config.pairs = read_geoms(m, names, geoms, can_be_pressed);
  std::sort(config.pairs.begin(), config.pairs.end());
  const bool named = !config.pairs.empty();
  for (const int geom : soft) {
    if (contains(sensing, geom)) continue;
    config.bodies.push_back({config.name, geom, geom_name(m, geom), partners(m, config, named, geom), named,
                             config.materials, config.apply, config.bristles});
  }
  return config;
}

int contact_dimension(const mjModel& m, int instance) {
  const ContactConfig config = read_contact_config(m, instance);
  return sensor_dimension(config.output, 0) * static_cast<int>(config.bodies.size());
}

}  // namespace taxel
