// Writes layout files: fixed key order, unknown keys at their old places, one form for every number.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/json_text.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/file/taxel_value.h"
#include "core/layout/layout_fields.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;

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
Json value_json(const ValueRange& range, const std::string& pointer) {
  return {number(range.low, pointer + "/0"), number(range.high, pointer + "/1")};
}
Json value_json(const Tare& tare, const std::string& pointer) {
  return tare.first_reading ? Json("first_reading") : number(tare.value, pointer);
}
Json value_json(const std::vector<TaxelCalibration>& taxels, const std::string& pointer) {
  Json json = Json::array();
  for (std::size_t i = 0; i < taxels.size(); ++i)
    json.push_back(value_json(taxels[i], fmt::format("{}/{}", pointer, i)));
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
    json["taxels"].push_back(taxel_json<Json>(layout.taxels[i], fmt::format("/taxels/{}", i)));
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

}  // namespace taxel
