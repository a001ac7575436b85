// Reads layout files. Every value is read through a reader that knows its place in the document.
#include "core/layout/file/layout_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/json_reader.h"
#include "core/base/text/json_text.h"
#include "core/layout/file/layout_migration.h"
#include "core/layout/file/taxel_value.h"
#include "core/layout/layout_fields.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Value = JsonNode<Json>;
using Object = JsonObject<Json>;

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

/// Reads a value of a layout. The overloads are the types that a setting may have.
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
Curve read_value(const Value& value, const Curve&) {
  return read_curve(value);
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
template <class T>
std::optional<T> read_value(const Value& value, const std::optional<T>&) {
  return read_value(value, T{});
}

template <LayoutSettings S>
S read_value(const Value& value, const S&) {
  Object object(value);
  S settings;
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
  for_each_part(layout, [&]<class S>(const char* key, S& part) {
    root.optional(key, [&](const Value& value) { part = read_value(value, S{}); });
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

}  // namespace taxel
