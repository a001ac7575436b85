// Sensor descriptions of the predecessor's code in YAML: read, written, and their row of the table of formats.

#include "core/layout/formats/layout_format.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"

namespace taxel {
namespace {

class YamlValue {
 public:
  YamlValue(YAML::Node node, const std::string& file, std::string key)
      : node_(std::move(node)), file_(&file), key_(std::move(key)) {}

  /// Returns the place for messages: "line 8, key geomName", or the line only without a key.
  [[nodiscard]] std::string place() const;
  /// Throws Error naming the file and the place.
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_expected(const std::string& expected) const;

  [[nodiscard]] const std::string& key() const { return key_; }
  [[nodiscard]] bool is_list() const { return node_.IsSequence(); }
  [[nodiscard]] bool is_map() const { return node_.IsMap(); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] double number() const;  ///< finite number; a quoted number is a text
  [[nodiscard]] dvec3 vector() const;   ///< list of three numbers
  [[nodiscard]] std::vector<YamlValue> items() const;
  /// Returns the values by key. Throws Error if a key is listed twice.
  [[nodiscard]] std::map<std::string, YamlValue> entries() const;

 private:
  [[nodiscard]] std::string shown() const;
  YAML::Node node_;
  const std::string* file_;
  std::string key_;
};

/// Largest size of a file. A sensor description of ten thousand taxels has less than 1 MB, and the parser needs up to
/// three hundred times the memory of its text.
constexpr std::size_t kMaxBytes = 2u << 20;

std::string line_text(const YAML::Mark& mark) {
  return mark.line >= 0 ? fmt::format("line {}", mark.line + 1) : "";
}

/// Throws Error for a text on which the parser does not end: yaml-cpp never consumes a comma outside of brackets and
/// returns empty documents for ever.
class StandstillCheck : public YAML::EventHandler {
 public:
  explicit StandstillCheck(const std::string& file) : file_(file) {}
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == last_) throw Error(file_, line_text(mark), "is no YAML: a document cannot begin here");
    last_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  const std::string& file_;
  int last_ = -1;  ///< position of the previous document in the text
};

void check_for_standstill(const std::string& text, const std::string& file) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  StandstillCheck check(file);
  while (parser.HandleNextDocument(check)) continue;
}

std::string YamlValue::place() const {
  const std::string line = line_text(node_.Mark());
  if (key_.empty()) return line;
  return line.empty() ? "key " + key_ : line + ", key " + key_;
}

void YamlValue::fail(const std::string& message) const {
  throw Error(*file_, place(), message);
}

std::string YamlValue::shown() const {
  if (node_.IsMap()) return "a map";
  if (node_.IsSequence()) return fmt::format("a list of {}", node_.size());
  if (node_.IsNull()) return "empty";
  const std::string& value = node_.Scalar();
  return value.size() > 60 ? "a long text" : "\"" + value + "\"";
}

void YamlValue::fail_expected(const std::string& expected) const {
  fail(fmt::format("must be {}, is {}", expected, shown()));
}

std::string YamlValue::text() const {
  if (!node_.IsScalar()) fail_expected("a text");
  return node_.Scalar();
}

double YamlValue::number() const {
  const bool quoted = node_.IsScalar() && node_.Tag() == "!";
  if (!node_.IsScalar() || quoted) fail_expected("a number");
  const std::string& written = node_.Scalar();
  const char* const begin = written.data() + (written.starts_with('+') ? 1 : 0);
  const char* const end = written.data() + written.size();
  double value = 0;
  const auto read = std::from_chars(begin, end, value);
  const std::string word = written.substr(
      written.find_first_not_of("+-.") == std::string::npos ? written.size() : written.find_first_not_of("+-."));
  const bool not_finite = word == "nan" || word == "NaN" || word == "NAN" || word == "inf" || word == "Inf" ||
                          word == "INF" || read.ec == std::errc::result_out_of_range;
  if (not_finite) fail_expected("a finite number");
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) fail_expected("a number");
  return value;
}

dvec3 YamlValue::vector() const {
  if (!node_.IsSequence() || node_.size() != 3) fail_expected("a list of 3 numbers");
  const std::vector<YamlValue> parts = items();
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

std::vector<YamlValue> YamlValue::items() const {
  if (!node_.IsSequence()) fail_expected("a list");
  std::vector<YamlValue> found;
  found.reserve(node_.size());
  for (const YAML::Node& item : node_) found.emplace_back(item, *file_, fmt::format("{}[{}]", key_, found.size()));
  return found;
}

std::map<std::string, YamlValue> YamlValue::entries() const {
  if (!node_.IsMap()) fail_expected("a map");
  std::map<std::string, YamlValue> found;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) YamlValue(entry.first, *file_, key_).fail("a key must be a text");
    const std::string name = entry.first.Scalar();
    const auto [at, fresh] = found.emplace(name, YamlValue(entry.second, *file_, name));
    if (!fresh) YamlValue(entry.first, *file_, name).fail("is listed twice");
  }
  return found;
}

/// Returns the documents of a YAML text. Throws Error naming the file and the line if the text is not YAML.
std::vector<YamlValue> parse_yaml(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes)
    throw Error(file, fmt::format("has {} bytes: a sensor description has at most {}", text.size(), kMaxBytes));
  try {
    check_for_standstill(text, file);
    std::vector<YamlValue> documents;
    for (const YAML::Node& document : YAML::LoadAll(text)) documents.emplace_back(document, file, "");
    return documents;
  } catch (const YAML::Exception& e) {
    throw Error(file, line_text(e.mark), "is no YAML: " + e.msg);
  }
}

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

namespace {

constexpr HeldValues kHeldBySensorYaml{false, false, true, true, false, true, false, true};

/// Returns a number that every parser of YAML takes for a number with decimals, in the shortest form that reads back.
std::string yaml_number(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (text.find('.') == std::string::npos) text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

std::string yaml_vector(const dvec3& v) {
  return fmt::format("[{}, {}, {}]", yaml_number(v.x), yaml_number(v.y), yaml_number(v.z));
}

std::string yaml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

void append_taxels(std::string& text, const ImportedLayout& one, std::vector<std::string>& notes) {
  const std::vector<Taxel>& taxels = one.layout.taxels;
  const auto [least, most] = std::minmax_element(taxels.begin(), taxels.end(),
                                                 [](const Taxel& a, const Taxel& b) { return a.radius < b.radius; });
  if (least->radius != most->radius)
    notes.push_back(
        fmt::format("a sensor has one radius for all taxels: the largest is written, {} m (the smallest is {} m)",
                    most->radius, least->radius));
  text += fmt::format("        include_margin: {}\n        taxels:\n", yaml_number(most->radius));
  for (const Taxel& taxel : taxels) text += "          - " + yaml_vector(taxel.center) + "\n";
  if (!one.has_normals) return;
  text += "        normals:\n";
  for (const Taxel& taxel : taxels) text += "          - " + yaml_vector(taxel.normal) + "\n";
}

void append_sensor(std::string& text, const ImportedLayout& one, std::vector<std::string>& notes) {
  const char* const type = one.cell > 0 ? "FlatTactileSensor" : one.has_normals ? "CurvedSensor" : "TaxelSensor";
  text += fmt::format("      - type: mujoco_contact_surface_sensors/{}\n        sensorName: {}\n        geomName: {}\n",
                      type, yaml_text(one.layout.name), yaml_text(one.geom));
  if (one.cell > 0) {
    text += fmt::format("        resolution: {}\n", yaml_number(one.cell));
    return;
  }
  const double density = one.layout.sampling.density;
  if (one.has_density && density >= 1) text += fmt::format("        sample_resolution: {}\n", yaml_number(density));
  append_taxels(text, one, notes);
}

WrittenLayouts write_sensor_yaml(const std::vector<ImportedLayout>& layouts) {
  WrittenLayouts written;
  written.bytes =
      "MujocoPlugins:\n  - type: mujoco_contact_surfaces/MujocoContactSurfacesPlugin\n    SurfacePlugins:\n";
  written.notes = losses_in(layouts, kHeldBySensorYaml, "a sensor description");
  bool has_geoms = true;
  for (const ImportedLayout& one : layouts) {
    if (one.cell <= 0) check_taxels_to_write({one});
    if (one.has_normals && one.cell <= 0) require_normals({one}, "a CurvedSensor");
    append_sensor(written.bytes, one, written.notes);
    has_geoms = has_geoms && !one.geom.empty();
  }
  written.notes.emplace_back(has_geoms ? "topicName and updateRate are to be added to the file"
                                       : "geomName, topicName and updateRate are to be filled in");
  return written;
}

}  // namespace

LayoutFormat sensor_yaml_format() {
  LayoutFormat format{"yaml", "Sensor description of mujoco_contact_surfaces", {".yaml", ".yml"}};
  format.holds = kHeldBySensorYaml;
  format.reads_several = format.writes_several = true;
  format.parse = parse_sensors_yaml;
  format.write = write_sensor_yaml;
  return format;
}

}  // namespace taxel
