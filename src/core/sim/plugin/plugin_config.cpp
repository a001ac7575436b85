#include "core/sim/plugin/plugin_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"
#include "core/sim/plugin/plugin_instances.h"
#include "core/sim/plugin/reported_values.h"
#include "core/sim/plugin/skin_bits.h"

namespace taxel {
namespace {

/// Returns true if two geoms cannot move against each other.
bool fixed_together(const mjModel& m, int a, int b) {
  return m.body_weldid[m.geom_bodyid[a]] == m.body_weldid[m.geom_bodyid[b]];
}

/// Returns true if a sensor touches a geom by default: MuJoCo lets its geom collide with the other one, or else a geom
/// of its body. An <exclude> of the two bodies may be there to replace MuJoCo's own contact, so it counts only if the
/// geom itself cannot collide. The keys `contype` and `conaffinity` add bits of contact.
bool touches_by_default(const mjModel& m, const SkinBits& skins, int geom, int other) {
  return other != geom &&
         (would_collide(m, geom, other) || can_body_touch(m, geom, other) || skins.let_touch(geom, other));
}

/// Reads the key `other_ids`, which this program writes: geoms without a name are touched too.
std::vector<int> read_ids(const mjModel& m, const std::string& value) {
  std::vector<int> ids;
  for (const std::string& word : split_words(value)) {
    int id = -1;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error != std::errc{} || end != word.data() + word.size() || id < 0 || id >= m.ngeom)
      throw Error("", "other_ids", fmt::format("must be ids of the {} geoms, has \"{}\"", m.ngeom, word));
    ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Returns true if no geom of the body can collide: the body is only drawn, as fingers of a robot may be whose
/// collisions nobody modelled.
bool is_only_drawn(const mjModel& m, const SkinBits& skins, int body) {
  const int first = m.body_geomadr[body], end = first + m.body_geomnum[body];
  for (int g = first; g < end; ++g)
    if (skins.of(g).any()) return false;
  return true;
}

/// Returns the geoms that a sensor touches by default: on a body that is only drawn all that can collide.
std::vector<int> default_others(const mjModel& m, int geom) {
  const SkinBits skins(m);
  std::vector<int> others;
  for (int g = 0; g < m.ngeom; ++g)
    if (touches_by_default(m, skins, geom, g)) others.push_back(g);
  if (!others.empty() || !is_only_drawn(m, skins, m.geom_bodyid[geom])) return others;
  for (int g = 0; g < m.ngeom; ++g)
    if (skins.of(g).any() && !fixed_together(m, geom, g)) others.push_back(g);
  return others;
}

std::vector<int> find_others(const mjModel& m, const GeomNames& names, const std::string& value, int geom) {
  std::vector<int> others;
  if (value.empty()) return default_others(m, geom);
  if (value == kAllGeoms) {
    for (int g = 0; g < m.ngeom; ++g)
      if (g != geom && !fixed_together(m, geom, g)) others.push_back(g);
    return others;
  }
  for (const std::string& name : split_words(value)) {
    if (name == kAllGeoms) throw Error("", "others", "\"*\" means all geoms, so it is not given with other names");
    const int g = names.find(name, "others");
    if (g == geom) throw Error("", "others", "\"" + name + "\" is the sensor's own geom");
    if (std::find(others.begin(), others.end(), g) == others.end()) others.push_back(g);
  }
  if (others.empty()) throw Error("", "others", "names no geom: leave the key out for all geoms that would collide");
  std::sort(others.begin(), others.end());
  return others;
}

int read_count(const std::string& value, const char* key) {
  int count = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), count);
  if (error != std::errc{} || end != value.data() + value.size() || count < 1)
    throw Error("", key, "must be a whole number above 0, is \"" + value + "\"");
  return count;
}

/// Reads the keys on which the size of the output depends: layout and output.
SensorConfig read_basics(const mjModel& m, int instance) {
  SensorConfig config;
  config.name = instance_name(m, instance);
  config.layout = config_value(m, instance, "layout");
  const std::string taxels = config_value(m, instance, "taxels");
  if (config.layout.empty() && taxels.empty()) throw Error("", "layout", "is required: the layout file");
  if (!config.layout.empty() && !taxels.empty())
    throw Error("", "taxels", "is for sensors that a program hands over; it excludes \"layout\"");
  if (!taxels.empty()) config.handed_taxels = read_count(taxels, "taxels");
  config.output = read_output(
      config_value(m, instance, "output"),
      {Output::readings, Output::wrench, Output::elastic_wrench, Output::area, Output::slip, Output::calibrated});
  if (has_output(config, Output::calibrated) && config.handed_taxels > 0)
    throw Error("", "output", "\"calibrated\" needs a layout with a calibration, so \"taxels\" excludes it");
  config.bristles = read_bristles(m, instance);
  return config;
}

/// Returns the layout that the key `layout` names, at any time after the assets are known.
FoundLayout layout_of(const mjModel& m, int instance, const SensorConfig& config) {
  int geom = -1;  // only the order of the folders depends on the geom
  try {
    geom = GeomNames(m, instance).sensor_geom();
  } catch (const Error&) {  // the geom may be known only when the model is complete
  }
  return find_layout(config.layout, layout_folders(m, geom));
}

}  // namespace

std::vector<std::string> split_words(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<Output> read_output(const std::string& value, const std::vector<Output>& allowed) {
  if (value.empty()) return {allowed.front()};
  const auto word_of = [](Output block) {
    constexpr const char* kWords[] = {"readings", "wrench", "elastic_wrench", "area", "slip", "calibrated"};
    return kWords[static_cast<std::size_t>(block)];
  };
  std::vector<Output> output;
  for (const std::string& word : split_words(value)) {
    const auto block =
        std::find_if(allowed.begin(), allowed.end(), [&](Output candidate) { return word == word_of(candidate); });
    if (block == allowed.end()) {
      std::vector<std::string> words;
      for (const Output candidate : allowed) words.emplace_back(word_of(candidate));
      throw Error("", "output", fmt::format("unknown word \"{}\"; the words are: {}", word, fmt::join(words, ", ")));
    }
    output.push_back(*block);
  }
  return output;
}

bool read_force(const mjModel& m, int instance) {
  const std::string force = config_value(m, instance, "force");
  if (!force.empty() && force != "apply" && force != "sense")
    throw Error("", "force", "must be \"apply\" or \"sense\", is \"" + force + "\"");
  return force != "sense";
}

BristleSettings read_bristles(const mjModel& m, int instance) {
  BristleSettings bristles;
  const std::string stiffness = config_value(m, instance, "tangential_stiffness"),
                    count = config_value(m, instance, "bristles");
  if (!stiffness.empty()) {
    bristles.given = true;
    const auto [end, error] =
        std::from_chars(stiffness.data(), stiffness.data() + stiffness.size(), bristles.stiffness);
    if (error != std::errc{} || end != stiffness.data() + stiffness.size() || !(bristles.stiffness >= 0) ||
        !std::isfinite(bristles.stiffness))
      throw Error("", "tangential_stiffness",
                  fmt::format("must be a number of Pa/m that is not negative, is \"{}\"", stiffness));
  }
  if (count.empty()) return bristles;
  if (!bristles.has_bristles())
    throw Error("", "bristles", "is only for friction that sticks: give \"tangential_stiffness\" as well");
  bristles.count = read_count(count, "bristles");
  if (bristles.count > kMostBristles)
    throw Error("", "bristles", fmt::format("must be at most {}, is {}", kMostBristles, bristles.count));
  return bristles;
}

OtherMaterials read_materials(const mjModel& m, int instance) {
  const std::string text = config_value(m, instance, "materials");
  OtherMaterials materials;
  if (text.empty()) return materials;
  const GeomNames names(m, instance);
  for (const auto& [written, material] : parse_materials(text, "materials")) {
    const std::string name = written == kAllGeoms ? written : geom_name(m, names.find(written, "materials"));
    if (!materials.emplace(name, material).second)
      throw Error("", "materials", fmt::format("names geom \"{}\" twice, also as \"{}\"", name, written));
  }
  return materials;
}

SensorConfig read_sensor_config(const mjModel& m, int instance) {
  SensorConfig config = read_basics(m, instance);
  const GeomNames names(m, instance);
  config.geom = names.sensor_geom();
  if (config.geom < 0)
    throw Error("", "geom",
                "is required: the name of the sensor's geom, unless the entry under <sensor> refers to it (objtype, "
                "objname)");
  config.geom_name = m.names + m.name_geomadr[config.geom];
  const std::string others = config_value(m, instance, "others");
  const std::string ids = config_value(m, instance, "other_ids");
  if (!ids.empty() && !others.empty()) throw Error("", "other_ids", "excludes \"others\": give one of the two");
  static_cast<void>(read_skin_bits(m, instance));  // reports values that are not masks
  config.others = ids.empty() ? find_others(m, names, others, config.geom) : read_ids(m, ids);
  config.others_named = !others.empty() && others != kAllGeoms;
  config.materials = read_materials(m, instance);
  config.apply = read_force(m, instance);
  return config;
}

std::vector<std::filesystem::path> layout_folders(const mjModel& m, int geom) {
  std::vector<std::filesystem::path> folders;
  const auto add = [&](const std::filesystem::path& folder) {
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  };
  const auto add_folder_of = [&](int mesh) {
    if (mesh < 0 || m.mesh_pathadr[mesh] < 0) return;
    const std::filesystem::path file = m.paths + m.mesh_pathadr[mesh];
    add(file.has_parent_path() ? file.parent_path() : ".");
  };
  if (geom >= 0 && m.geom_type[geom] == mjGEOM_MESH) add_folder_of(m.geom_dataid[geom]);
  for (int mesh = 0; mesh < m.nmesh; ++mesh) add_folder_of(mesh);
  add(".");
  return folders;
}

int sensor_dimension(const std::vector<Output>& output, int taxels) {
  int size = 0;
  for (const Output block : output) {
    if (block == Output::readings || block == Output::slip || block == Output::calibrated) size += taxels;
    if (block == Output::wrench || block == Output::elastic_wrench) size += 6;
    if (block == Output::area) size += 1;
  }
  return size;
}

int sensor_dimension(const mjModel& m, int instance) {
  const SensorConfig config = read_basics(m, instance);
  if (config.handed_taxels > 0) return sensor_dimension(config.output, config.handed_taxels);
  const FoundLayout found = layout_of(m, instance, config);
  return sensor_dimension(config.output, static_cast<int>(found.layout.taxels.size()));
}

BristleSettings bristles_with_layout(const BristleSettings& keys, const Layout& layout) {
  if (keys.given) return keys;
  return {layout.material.tangential_stiffness, layout.material.bristles};
}

BristleSettings sensor_bristles(const mjModel& m, int instance) {
  const SensorConfig config = read_basics(m, instance);
  if (config.bristles.given || config.handed_taxels > 0) return config.bristles;
  return bristles_with_layout(config.bristles, layout_of(m, instance, config).layout);
}

bool has_output(const SensorConfig& config, Output block) {
  return std::find(config.output.begin(), config.output.end(), block) != config.output.end();
}

void check_calibrated_output(const SensorConfig& config, const Layout& layout) {
  if (has_output(config, Output::calibrated) && !layout.calibration)
    throw Error("", "output",
                "\"calibrated\" needs a calibration, and the layout has none: add the key \"calibration\"");
}

int chain_state_size(const mjModel& m, int instance) {
  const SensorConfig config = read_basics(m, instance);
  if (!has_output(config, Output::calibrated)) return 0;
  const FoundLayout found = layout_of(m, instance, config);
  if (!found.layout.calibration) return 0;  // the instance reports this
  return ReportedValues::state_size(m, found.layout);
}

void check_slip_output(const SensorConfig& config) {
  if (has_output(config, Output::slip) && !config.bristles.has_bristles())
    throw Error("", "output",
                "\"slip\" needs friction that sticks: give \"tangential_stiffness\" as well, here or in the layout's "
                "material");
}

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
