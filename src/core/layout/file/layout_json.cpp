// Layout files and taxels on the clipboard. Every value is read through a reader that knows its place in the document.
// Written are a fixed key order, unknown keys at their old places, and one form for every number.

#include "core/layout/file/layout_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/base/text/law_json.h"
#include "core/layout/file/layout_keys.h"
#include "core/layout/layout_fields.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Value = JsonNode<Json>;
using Object = JsonObject<Json>;

Subtaxel read_subtaxel(const Value& value) {
  Object object(value);
  Subtaxel subtaxel;
  subtaxel.center = object.required("center").vector3();
  subtaxel.normal = object.required("normal").vector3();
  subtaxel.radius = object.required("radius").number();
  object.keep_unknown();
  return subtaxel;
}

/// Reads a taxel. `index` is its id if the object has none.
Taxel read_taxel(const Value& value, std::size_t index) {
  Object object(value);
  Taxel taxel;
  taxel.id = static_cast<int>(index);
  object.optional("id", [&](const Value& v) { taxel.id = v.small_integer(); });
  object.text("name", taxel.name);
  taxel.center = object.required("center").vector3();
  taxel.normal = object.required("normal").vector3();
  taxel.radius = object.required("radius").number();
  object.optional("subtaxels", [&](const Value& v) {
    for (std::size_t i = 0; i < v.length(); ++i) taxel.subtaxels.push_back(read_subtaxel(v.item(i)));
  });
  object.number("density", taxel.density);
  object.keep_unknown();
  return taxel;
}

/// Writes the three values that taxels and subtaxels share.
template <class T>
void write_disc(Json& json, const T& disc, const std::string& pointer) {
  json["center"] = json_vector<Json>(disc.center, pointer + "/center");
  json["normal"] = json_vector<Json>(disc.normal, pointer + "/normal");
  json["radius"] = json_number<Json>(disc.radius, pointer + "/radius");
}

Json taxel_json(const Taxel& taxel, const std::string& pointer) {
  Json json = {{"id", taxel.id}, {"name", taxel.name}};
  write_disc(json, taxel, pointer);
  json["subtaxels"] = Json::array();
  for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i) {
    Json subtaxel = Json::object();
    write_disc(subtaxel, taxel.subtaxels[i], fmt::format("{}/subtaxels/{}", pointer, i));
    json["subtaxels"].push_back(std::move(subtaxel));
  }
  if (taxel.density != 0.0) json["density"] = json_number<Json>(taxel.density, pointer + "/density");
  return json;
}

/// Throws Error for JSON of another program, with its first keys.
void refuse_foreign(const Json& json, const std::string& file) {
  constexpr std::size_t kShown = 5;
  if (!json.is_object() || json.empty() || json.contains("format") || json.contains("mesh")) return;
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) {
    if (keys.size() == kShown) break;
    const bool is_word = value.is_string() && !value.get_ref<const std::string&>().empty();
    keys.push_back(fmt::format("\"{}\"", short_quote(key)));
    if (is_word) keys.back() += fmt::format(": \"{}\"", short_quote(value.get<std::string>()));
  }
  if (json.size() > kShown) keys.emplace_back("...");
  throw Error(
      file, "/format",
      fmt::format("is missing: this is JSON of another program with the keys {}. Taxels of other programs are read "
                  "from a table: columns x, y, z, nx, ny, nz with their unit, \"x [mm]\"",
                  fmt::join(keys, ", ")));
}

void read_head(Object& root, const std::string& file) {
  const Value format = root.required("format");
  if (format.text() != "taxel-layout") format.wrong("\"taxel-layout\"");
  const Value version = root.required("version");
  const double v = version.number();
  if (v != kLayoutVersion)
    throw Error(file, "/version",
                fmt::format("{} is unknown, this program reads version {} and older ones", v, kLayoutVersion));
}

/// Reads runs of faces, [first, last] each.
std::vector<int> read_region(const Value& value) {
  constexpr std::int64_t kMaxFaces = 100'000'000;  // a mesh with more faces does not fit in memory
  std::vector<int> faces;
  for (std::size_t i = 0; i < value.length(); ++i) {
    const Value run = value.item(i);
    if (run.length() != 2) run.wrong("an array of 2 faces, the first and the last of a run");
    const int first = run.item(0).small_integer(), last = run.item(1).small_integer();
    if (first < 0 || last < first) run.wrong("the first and the last of a run of faces, 0 or more and ascending");
    if (!faces.empty() && first <= faces.back()) run.wrong(fmt::format("a run behind face {}", faces.back()));
    if (static_cast<std::int64_t>(faces.size()) + last - first >= kMaxFaces)
      run.wrong(fmt::format("at most {} faces in all", kMaxFaces));
    for (std::int64_t face = first; face <= last; ++face) faces.push_back(static_cast<int>(face));
  }
  return faces;
}

Curve read_curve(const Value& value) {
  if (value.length() < 2) value.wrong("an array of 2 points or more");
  Curve curve;
  for (std::size_t i = 0; i < value.length(); ++i) {
    const Value point = value.item(i);
    if (point.length() != 2) point.wrong("an array of 2 numbers");
    curve.push_back({point.item(0).number(), point.item(1).number()});
  }
  return curve;
}

/// Reads a value of a layout. The overloads are the types that a setting may have. An object keeps the settings of the
/// second argument whose keys are missing.
double read_value(const Value& value, const double&) {
  return value.number();
}
int read_value(const Value& value, const int&) {
  return value.small_integer();
}
std::uint64_t read_value(const Value& value, const std::uint64_t&) {
  return value.natural();
}
bool read_value(const Value& value, const bool&) {
  return value.flag();
}
std::string read_value(const Value& value, const std::string&) {
  return value.text();
}
dvec3 read_value(const Value& value, const dvec3&) {
  return value.vector3();
}
FaceSet read_value(const Value& value, const FaceSet&) {
  return read_region(value);
}
std::vector<double> read_value(const Value& value, const std::vector<double>&) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value.length(); ++i) numbers.push_back(value.item(i).number());
  return numbers;
}
CrosstalkMatrix read_value(const Value& value, const CrosstalkMatrix&) {
  CrosstalkMatrix rows;
  for (std::size_t i = 0; i < value.length(); ++i) rows.push_back(read_value(value.item(i), std::vector<double>{}));
  return rows;
}
Curve read_value(const Value& value, const Curve&) {
  return read_curve(value);
}
PressureLaw read_value(const Value& value, const PressureLaw&) {
  return read_law(value);
}
ValueRange read_value(const Value& value, const ValueRange&) {
  if (value.length() != 2) value.wrong("an array of 2 numbers");
  return {value.item(0).number(), value.item(1).number()};
}
Tare read_value(const Value& value, const Tare&) {
  if (value.is_text() && value.text() != "first_reading") value.wrong("a number or \"first_reading\"");
  return value.is_text() ? Tare{true, 0.0} : Tare{false, value.number()};
}
template <class E>
requires std::is_enum_v<E> E read_value(const Value& value, const E&) {
  return value.word<E>();
}
template <LayoutSettings S>
S read_value(const Value& value, const S&);

TaxelCalibration read_taxel_calibration(const Value& value) {
  value.must_be_object();
  const int id = value.at("id").small_integer();
  try {
    return read_value(value, TaxelCalibration{});
  } catch (const Error& e) {
    throw Error(e.file(), e.where(), fmt::format("{} (taxel {})", e.message(), id));
  }
}
std::vector<TaxelCalibration> read_value(const Value& value, const std::vector<TaxelCalibration>&) {
  std::vector<TaxelCalibration> taxels;
  for (std::size_t i = 0; i < value.length(); ++i) taxels.push_back(read_taxel_calibration(value.item(i)));
  return taxels;
}
template <LayoutSettings S>
std::vector<S> read_value(const Value& value, const std::vector<S>&) {
  std::vector<S> list;
  for (std::size_t i = 0; i < value.length(); ++i) list.push_back(read_value(value.item(i), S{}));
  return list;
}
template <class T>
std::optional<T> read_value(const Value& value, const std::optional<T>&) {
  return read_value(value, T{});
}

template <LayoutSettings S>
S read_value(const Value& value, const S& usual) {
  Object object(value);
  S settings = usual;
  for_each_field<S>([&](const LayoutField& field, auto member) {
    if (field.presence == Presence::required)
      settings.*member = read_value(object.required(field.spec.key), settings.*member);
    else
      object.optional(field.spec.key, [&](const Value& v) { settings.*member = read_value(v, settings.*member); });
  });
  object.keep_unknown();
  return settings;
}

Layout layout_of(const Json& json, const std::string& file) {
  Layout layout;
  refuse_foreign(json, file);
  Object root(Value(json, file, &layout.unknown));
  read_head(root, file);
  root.text("name", layout.name);
  if (!json.contains("mesh")) throw Error(file, "/mesh/file", "is missing");
  for_each_part(layout, [&](const char* key, auto& part) {
    root.optional(key, [&](const Value& value) { part = read_value(value, part); });
  });
  const Value taxels = root.required("taxels");
  for (std::size_t i = 0; i < taxels.length(); ++i) layout.taxels.push_back(read_taxel(taxels.item(i), i));
  root.optional("calibration", [&](const Value& value) { layout.calibration = read_value(value, Calibration{}); });
  root.keep_unknown();
  return layout;
}

}  // namespace

Layout parse_layout(const std::string& text, const std::string& file) {
  return parse_layout_of_file(text, file).layout;
}

Layout read_layout(const std::filesystem::path& path) {
  return read_layout_of_file(path).layout;
}

LayoutOfFile read_layout_of_file(const std::filesystem::path& path) {
  return parse_layout_of_file(read_file(path), path.string());
}

LayoutOfFile parse_layout_of_file(const std::string& text, const std::string& file) {
  Json json = parse_json<Json>(text, file);
  std::vector<std::string> notes = migrate_layout(json, file);
  try {
    return {layout_of(json, file), json.contains("frame"), std::move(notes)};
  } catch (const Error& e) {
    if (notes.empty()) throw;
    throw Error(e.file(), e.where(), e.message() + " (place and key are those of version 1)");
  }
}

std::filesystem::path mesh_path(const Layout& layout, const std::filesystem::path& layout_file) {
  const std::filesystem::path mesh(layout.mesh.file);
  return mesh.is_absolute() ? mesh : (layout_file.parent_path() / mesh).lexically_normal();
}

namespace {

Json number(double v, const std::string& pointer) {
  return json_number<Json>(v, pointer);
}

Json vector(const dvec3& v, const std::string& pointer) {
  return json_vector<Json>(v, pointer);
}

template <class E>
Json word(E value) {
  return std::string(to_word(value));
}

/// Returns runs of faces, [first, last] each.
Json region_json(const std::vector<int>& faces) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t last = i;
    while (last + 1 < faces.size() && faces[last + 1] == faces[last] + 1) ++last;
    runs.push_back({faces[i], faces[last]});
    i = last + 1;
  }
  return runs;
}

/// Returns true if /mesh/repair has unknown keys, which need its object.
bool has_unknown_repair_keys(const Layout& layout) {
  const std::string start = "/mesh/repair/";
  const auto first = layout.unknown.lower_bound(start);
  return first != layout.unknown.end() && first->first.starts_with(start);
}

Json curve_json(const Curve& curve, const std::string& pointer) {
  Json json = Json::array();
  for (std::size_t i = 0; i < curve.size(); ++i)
    json.push_back(Json::array({number(curve[i].reading, fmt::format("{}/{}/0", pointer, i)),
                                number(curve[i].value, fmt::format("{}/{}/1", pointer, i))}));
  return json;
}

template <LayoutSettings S>
Json value_json(const S& settings, const std::string& pointer);

/// Writes a value of a layout. The overloads are the types that a setting may have.
Json value_json(double value, const std::string& pointer) {
  return number(value, pointer);
}
template <class T>
requires std::is_integral_v<T> Json value_json(T value, const std::string&) {
  return value;
}
template <class E>
requires std::is_enum_v<E> Json value_json(E value, const std::string&) {
  return word(value);
}
Json value_json(const std::string& value, const std::string&) {
  return value;
}
Json value_json(const dvec3& value, const std::string& pointer) {
  return vector(value, pointer);
}
Json value_json(const FaceSet& faces, const std::string&) {
  return region_json(*faces);
}
Json value_json(const Curve& curve, const std::string& pointer) {
  return curve_json(curve, pointer);
}
Json value_json(const PressureLaw& law, const std::string&) {
  return law_json<Json>(law);
}
Json value_json(const ValueRange& range, const std::string& pointer) {
  return {number(range.low, pointer + "/0"), number(range.high, pointer + "/1")};
}
Json value_json(const Tare& tare, const std::string& pointer) {
  return tare.first_reading ? Json("first_reading") : number(tare.value, pointer);
}
/// Writes a list of numbers, of lists of numbers, or of settings.
template <class T>
Json value_json(const std::vector<T>& list, const std::string& pointer) {
  Json json = Json::array();
  for (std::size_t i = 0; i < list.size(); ++i) json.push_back(value_json(list[i], fmt::format("{}/{}", pointer, i)));
  return json;
}
template <class T>
Json value_json(const std::optional<T>& value, const std::string& pointer) {
  return value_json(*value, pointer);  // without a value it equals its default and is not written
}

template <LayoutSettings S>
Json value_json(const S& settings, const std::string& pointer) {
  const S usual{};
  Json json = Json::object();
  for_each_field<S>([&](const LayoutField& field, auto member) {
    if (field.presence == Presence::sparse && settings.*member == usual.*member) return;
    json[field.spec.key] = value_json(settings.*member, fmt::format("{}/{}", pointer, field.spec.key));
  });
  return json;
}

/// Adds the unknown keys. A key whose object no longer exists, such as a deleted taxel, is dropped.
void restore_unknown(Json& json, const std::map<std::string, std::string>& unknown) {
  for (const auto& [text, value] : unknown) {
    try {
      const Json::json_pointer pointer(text);
      if (pointer.empty() || !json.contains(pointer.parent_pointer())) continue;
      Json& parent = json[pointer.parent_pointer()];
      if (parent.is_object() && !parent.contains(pointer.back())) parent[pointer.back()] = Json::parse(value);
    } catch (const nlohmann::json::exception&) {
      throw Error("", text, "unknown key cannot be written back: its place or its value is no JSON");
    }
  }
}

}  // namespace

std::string layout_to_json(const Layout& layout) {
  Json json = {{"format", "taxel-layout"}, {"version", 1}, {"name", layout.name}};
  for_each_part(layout,
                [&](const char* key, const auto& part) { json[key] = value_json(part, fmt::format("/{}", key)); });
  if (has_unknown_repair_keys(layout) && !json["mesh"].contains("repair")) json["mesh"]["repair"] = Json::object();
  json["taxels"] = Json::array();
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    json["taxels"].push_back(taxel_json(layout.taxels[i], fmt::format("/taxels/{}", i)));
  if (layout.calibration) json["calibration"] = value_json(*layout.calibration, "/calibration");
  restore_unknown(json, layout.unknown);
  return json_text(json);
}

void write_layout(const std::filesystem::path& path, const Layout& layout) {
  std::string text;
  try {
    text = layout_to_json(layout);
  } catch (const Error& e) {
    throw Error(path.string(), e.where(), e.message());
  }
  write_file_atomically(path, text);
}

namespace {

constexpr int kClipboardVersion = 1;
constexpr const char* kExpected = "taxels as JSON: copied ones, a layout, an array of taxels, or one taxel";

/// Checks the format and the version of a copied selection or a layout. One taxel or an array has neither.
void check_head(Object& root) {
  root.optional("format", [](const Value& format) {
    const std::string word = format.text();
    if (word != "taxels" && word != "taxel-layout") format.wrong("\"taxels\" or \"taxel-layout\"");
  });
  root.optional("version", [](const Value& version) {
    if (version.number() != kClipboardVersion) version.wrong("1, the version that this program reads");
  });
}

}  // namespace

std::string taxels_to_json(const std::vector<Taxel>& taxels) {
  Json json = {{"format", "taxels"}, {"version", kClipboardVersion}, {"taxels", Json::array()}};
  for (std::size_t i = 0; i < taxels.size(); ++i)
    json["taxels"].push_back(taxel_json(taxels[i], fmt::format("/taxels/{}", i)));
  return json_text(json);
}

std::vector<Taxel> parse_taxels(const std::string& text, const std::string& source) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) throw Error(source, fmt::format("is empty; needed are {}", kExpected));
  if (text[begin] != '{' && text[begin] != '[') throw Error(source, fmt::format("holds no {}", kExpected));
  const Json json = parse_json<Json>(text, source);
  const Value root(json, source);
  std::vector<Taxel> taxels;
  const auto read_all = [&](const Value& array) {
    for (std::size_t i = 0; i < array.length(); ++i) taxels.push_back(read_taxel(array.item(i), i));
  };
  if (json.is_array()) {
    read_all(root);
  } else if (json.contains("center")) {
    taxels.push_back(read_taxel(root, 0));
  } else {
    Object object(root);
    if (!json.contains("taxels")) throw Error(source, fmt::format("holds no {}", kExpected));
    check_head(object);
    read_all(object.required("taxels"));
  }
  if (taxels.empty()) throw Error(source, "holds no taxel");
  return taxels;
}

}  // namespace taxel
