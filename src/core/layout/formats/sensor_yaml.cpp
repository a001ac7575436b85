#include "core/layout/formats/sensor_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/error.h"
#include "core/layout/formats/format_table.h"
#include "core/layout/formats/text/yaml_value.h"

namespace taxel {
namespace {

enum class Kind { curved, taxels, flat };

struct KindWord {
  std::string_view word;  ///< last part of `type`
  Kind kind;
};
constexpr std::array<KindWord, 3> kKinds{
    {{"CurvedSensor", Kind::curved}, {"TaxelSensor", Kind::taxels}, {"FlatTactileSensor", Kind::flat}}};

using Entries = std::map<std::string, YamlValue>;

/// A sensor of the file before it is read.
struct Found {
  YamlValue value;
  Entries entries;
  Kind kind;
  std::string name, geom;
};

const YamlValue* find(const Entries& entries, const std::string& key) {
  const auto at = entries.find(key);
  return at != entries.end() ? &at->second : nullptr;
}

const YamlValue& required(const YamlValue& map, const Entries& entries, const std::string& key, const char* what) {
  if (const YamlValue* value = find(entries, key)) return *value;
  map.fail(fmt::format("key {} is missing: {}", key, what));
}

std::string text_or_empty(const Entries& entries, const std::string& key) {
  const YamlValue* value = find(entries, key);
  return value != nullptr ? value->text() : "";
}

/// Returns "CurvedSensor" for "mujoco_contact_surface_sensors/CurvedSensor".
std::string last_part(const std::string& type) {
  return type.substr(type.find_last_of('/') + 1);
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The sensors under MujocoPlugins.
class SensorList {
 public:
  SensorList(const std::string& text, const std::string& file) : file_(file) {
    bool any = false;
    for (const YamlValue& document : parse_yaml(text, file_)) {
      if (!document.is_map()) continue;
      const Entries root = document.entries();
      const YamlValue* plugins = find(root, "MujocoPlugins");
      if (plugins == nullptr) continue;
      any = true;
      for (const YamlValue& plugin : plugins->items()) add_plugin(plugin);
    }
    if (!any) throw Error(file_, "", "holds no key MujocoPlugins: it is no sensor description");
    if (!sensors.empty()) return;
    if (!others_.empty())
      throw Error(file_, "key SurfacePlugins",
                  fmt::format("holds no CurvedSensor, TaxelSensor or FlatTactileSensor, but {}", listed(others_)));
    throw Error(file_, "key MujocoPlugins",
                fmt::format("no plugin holds SurfacePlugins; there {} {}", plugins_.size() == 1 ? "is" : "are",
                            plugins_.empty() ? "none" : listed(plugins_)));
  }
  std::vector<Found> sensors;

 private:
  void add_plugin(const YamlValue& plugin) {
    const Entries entries = plugin.entries();
    const YamlValue* surfaces = find(entries, "SurfacePlugins");
    plugins_.push_back(text_or_empty(entries, "type"));
    if (surfaces == nullptr) return;
    for (const YamlValue& surface : surfaces->items()) add_sensor(surface);
  }
  void add_sensor(const YamlValue& surface) {
    Entries entries = surface.entries();
    const std::string type = required(surface, entries, "type", "the kind of sensor").text();
    const auto kind =
        std::find_if(kKinds.begin(), kKinds.end(), [&](const KindWord& one) { return one.word == last_part(type); });
    if (kind == kKinds.end()) {
      others_.push_back(type);
      return;
    }
    std::string name = text_or_empty(entries, "sensorName"), geom = text_or_empty(entries, "geomName");
    sensors.push_back({surface, std::move(entries), kind->kind, std::move(name), std::move(geom)});
  }

  const std::string& file_;
  std::vector<std::string> plugins_, others_;  ///< types of plugins
};

double positive_number(const YamlValue& value) {
  const double v = value.number();
  if (!(v > 0)) value.fail(fmt::format("must be greater than 0, is {}", v));
  return v;
}

/// Reads one sensor as a layout.
class SensorReader {
 public:
  explicit SensorReader(const Found& sensor) : sensor_(sensor) {
    imported_.layout.name = sensor.name;
    imported_.geom = sensor.geom;
    imported_.has_density = imported_.has_material = imported_.has_frame = false;
    if (const YamlValue* geom = find(sensor.entries, "geomName")) imported_.geom_place = geom->place();
  }
  ImportedLayout read() {
    if (sensor_.kind == Kind::flat) {
      read_flat();
    } else {
      read_taxels();
    }
    read_density();
    note_readout();
    note_what_is_left();
    return std::move(imported_);
  }

 private:
  void note(std::string_view text) { imported_.notes.emplace_back(text); }
  const YamlValue& required(const char* key, const char* what) {
    used_.push_back(key);
    return taxel::required(sensor_.value, sensor_.entries, key, what);
  }
  const YamlValue* optional(const char* key) {
    used_.push_back(key);
    return find(sensor_.entries, key);
  }

  void read_taxels() {
    const double radius = positive_number(required("include_margin", "the receptive radius [m]"));
    const YamlValue& places = required("taxels", "a list of positions [m]");
    std::vector<Taxel>& taxels = imported_.layout.taxels;
    for (const YamlValue& place : places.items()) {
      Taxel taxel;
      taxel.id = static_cast<int>(taxels.size());
      taxel.center = place.vector();
      taxel.radius = radius;
      taxels.push_back(taxel);
    }
    if (taxels.empty()) places.fail("holds no taxel");
    read_normals();
  }
  void read_normals() {
    std::vector<Taxel>& taxels = imported_.layout.taxels;
    imported_.has_normals = sensor_.kind == Kind::curved;
    if (!imported_.has_normals) {
      imported_.set_all_normals_missing();
      note("a TaxelSensor has no normals: those of the skin are taken");
      return;
    }
    const YamlValue& normals = required("normals", "a CurvedSensor has one for each taxel");
    const std::vector<YamlValue> items = normals.items();
    if (items.size() != taxels.size())
      normals.fail(fmt::format("must be as many as the {} taxels, is a list of {}", taxels.size(), items.size()));
    for (std::size_t k = 0; k < taxels.size(); ++k) {
      taxels[k].normal = items[k].vector();
      if (!(glm::dot(taxels[k].normal, taxels[k].normal) > 0)) items[k].fail("must be a direction, is [0, 0, 0]");
    }
  }
  void read_flat() {
    imported_.cell = positive_number(required("resolution", "the edge length of a cell [m]"));
    note(
        fmt::format("a FlatTactileSensor lists no taxels: square cells of {} m over the top of the skin, a taxel in "
                    "the middle of each with a receptive radius of half a cell",
                    imported_.cell));
  }
  void read_density() {
    const YamlValue* value = optional("sample_resolution");
    if (value == nullptr || sensor_.kind == Kind::flat) return;
    const double density = positive_number(*value);
    if (density >= 1) {
      imported_.layout.sampling.density = density;
      imported_.has_density = true;
    } else {
      note(
          fmt::format("sample_resolution {} is below 1: a length on the contact surface [m] and no density of samples; "
                      "the default density is taken",
                      density));
    }
  }
  void note_readout() {
    if (const YamlValue* method = optional("method"))
      note(
          fmt::format("method \"{}\": readings are weighted means, as in the paper; --aggregate selects another "
                      "aggregate (weighted_sum is the one of the released code, which does not divide)",
                      method->text()));
    if (const YamlValue* method = optional("sample_method"))
      note(fmt::format("sample_method \"{}\": samples are spread evenly, each with the same weight", method->text()));
  }
  /// Adds a note on the keys that were not used.
  void note_what_is_left() {
    for (const char* key : {"type", "sensorName", "geomName"}) used_.emplace_back(key);
    std::vector<std::string> left;
    for (const auto& [key, value] : sensor_.entries)
      if (std::find(used_.begin(), used_.end(), key) == used_.end()) left.push_back(key);
    if (!left.empty()) note("not carried over: " + listed(left));
  }

  const Found& sensor_;
  std::vector<std::string> used_;
  ImportedLayout imported_;
};

}  // namespace

std::vector<ImportedLayout> parse_sensors_yaml(const std::string& text, const std::string& file) {
  const SensorList list(text, file);
  std::vector<ImportedLayout> sensors;
  for (const Found& sensor : list.sensors) sensors.push_back(SensorReader(sensor).read());
  return sensors;
}

ImportedLayout parse_sensor_yaml(const std::string& text, const std::string& file, const std::string& sensor) {
  return choose_sensor(parse_sensors_yaml(text, file), sensor, file);
}

}  // namespace taxel
