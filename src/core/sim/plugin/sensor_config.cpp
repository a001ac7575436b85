#include "core/sim/plugin/sensor_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/sim/model/geometry.h"

namespace taxel {
namespace {

/// Returns true if two geoms cannot move against each other.
bool fixed_together(const mjModel& m, int a, int b) {
  return m.body_weldid[m.geom_bodyid[a]] == m.body_weldid[m.geom_bodyid[b]];
}

/// Returns true if a sensor touches a geom by default: MuJoCo lets its geom collide with the other one, or else a geom
/// of its body. An <exclude> of the two bodies may be there to replace MuJoCo's own contact, so it counts only if the
/// geom itself cannot collide.
bool touches_by_default(const mjModel& m, int geom, int other) {
  return other != geom && (would_collide(m, geom, other) || can_body_touch(m, geom, other));
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
bool is_only_drawn(const mjModel& m, int body) {
  const int first = m.body_geomadr[body], end = first + m.body_geomnum[body];
  for (int g = first; g < end; ++g)
    if (can_collide(m, g)) return false;
  return true;
}

/// Returns the geoms that a sensor touches by default: on a body that is only drawn all that can collide.
std::vector<int> default_others(const mjModel& m, int geom) {
  std::vector<int> others;
  for (int g = 0; g < m.ngeom; ++g)
    if (touches_by_default(m, geom, g)) others.push_back(g);
  if (!others.empty() || !is_only_drawn(m, m.geom_bodyid[geom])) return others;
  for (int g = 0; g < m.ngeom; ++g)
    if (can_collide(m, g) && !fixed_together(m, geom, g)) others.push_back(g);
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
  config.output = read_output(config_value(m, instance, "output"),
                              {Output::readings, Output::wrench, Output::elastic_wrench, Output::area, Output::slip});
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
    constexpr const char* kWords[] = {"readings", "wrench", "elastic_wrench", "area", "slip"};
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
    if (block == Output::readings || block == Output::slip) size += taxels;
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

void check_slip_output(const SensorConfig& config) {
  const bool has_slip = std::find(config.output.begin(), config.output.end(), Output::slip) != config.output.end();
  if (has_slip && !config.bristles.has_bristles())
    throw Error("", "output",
                "\"slip\" needs friction that sticks: give \"tangential_stiffness\" as well, here or in the layout's "
                "material");
}

}  // namespace taxel
