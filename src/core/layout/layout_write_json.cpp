// Writing layout files: fixed key order, unknown keys back where they were, one form for every number.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/layout_json.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;

/// The shortest form that reads back exactly: whole numbers without a point, others by the shortest digits.
Json number(double v, const std::string& pointer) {
  if (!std::isfinite(v)) throw Error("", pointer, fmt::format("must be finite to be written, is {}", v));
  const double exact_limit = 1e15;
  if (v == std::floor(v) && std::abs(v) < exact_limit && !(v == 0.0 && std::signbit(v)))
    return static_cast<std::int64_t>(v);
  return v;
}

Json vector(const dvec3& v, const std::string& pointer) {
  return {number(v.x, pointer + "/0"), number(v.y, pointer + "/1"), number(v.z, pointer + "/2")};
}

template <class E>
Json word(E value) {
  return std::string(to_word(value));
}

void write_settings(Json& json, const Layout& layout) {
  json["mesh"] = {
      {"file", layout.mesh.file}, {"scale", vector(layout.mesh.scale, "/mesh/scale")}, {"sha256", layout.mesh.sha256}};
  json["frame"] = {{"distal", vector(layout.frame.distal, "/frame/distal")},
                   {"pad", vector(layout.frame.pad, "/frame/pad")}};
  json["sampling"] = {{"density", number(layout.sampling.density, "/sampling/density")},
                      {"seed", layout.sampling.seed},
                      {"weights", word(layout.sampling.weights)}};
  json["receptive_field"] = {
      {"metric", word(layout.receptive_field.metric)},
      {"max_angle_deg", number(layout.receptive_field.max_angle_deg, "/receptive_field/max_angle_deg")}};
  json["readout"] = {{"aggregate", word(layout.readout.aggregate)},
                     {"misses", word(layout.readout.misses)},
                     {"ray", word(layout.readout.ray)},
                     {"max_depth", number(layout.readout.max_depth, "/readout/max_depth")}};
  json["material"] = {{"field", word(layout.material.field)},
                      {"modulus", number(layout.material.modulus, "/material/modulus")},
                      {"thickness", number(layout.material.thickness, "/material/thickness")},
                      {"dissipation", number(layout.material.dissipation, "/material/dissipation")},
                      {"friction", number(layout.material.friction, "/material/friction")}};
}

/// The three values that a taxel and a subtaxel have in common.
template <class T>
void write_disc(Json& json, const T& disc, const std::string& pointer) {
  json["center"] = vector(disc.center, pointer + "/center");
  json["normal"] = vector(disc.normal, pointer + "/normal");
  json["radius"] = number(disc.radius, pointer + "/radius");
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
  return json;
}

/// Puts unknown keys back. One whose object is gone (its taxel was deleted) goes with it.
void restore_unknown(Json& json, const std::map<std::string, std::string>& unknown) {
  for (const auto& [text, value] : unknown) {
    try {
      const Json::json_pointer pointer(text);
      if (pointer.empty() || !json.contains(pointer.parent_pointer())) continue;
      Json& parent = json[pointer.parent_pointer()];
      if (parent.is_object() && !parent.contains(pointer.back())) parent[pointer.back()] = Json::parse(value);
    } catch (const nlohmann::json::exception& e) {
      throw Error("", text, fmt::format("unknown key cannot be written back: {}", e.what()));
    }
  }
}

/// Two-space indent, one key a line; arrays of plain values stay on one line.
void print(const Json& json, const std::string& indent, std::string& out) {
  const bool nested = json.is_structured() && std::any_of(json.begin(), json.end(), [&](const Json& item) {
                        return json.is_object() || item.is_structured();
                      });
  if (!json.is_structured() || json.empty()) {
    out += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const std::string inner = indent + "  ";
  const char* separator = "";
  out += json.is_object() ? "{" : "[";
  for (const auto& [key, item] : json.items()) {
    out += separator;
    if (nested) out += "\n" + inner;
    if (json.is_object()) out += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    print(item, inner, out);
    separator = nested ? "," : ", ";
  }
  if (nested) out += "\n" + indent;
  out += json.is_object() ? "}" : "]";
}

}  // namespace

std::string layout_to_json(const Layout& layout) {
  Json json = {{"format", "taxel-layout"}, {"version", 1}, {"name", layout.name}};
  write_settings(json, layout);
  json["taxels"] = Json::array();
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    json["taxels"].push_back(taxel_json(layout.taxels[i], fmt::format("/taxels/{}", i)));
  restore_unknown(json, layout.unknown);
  std::string text;
  print(json, "", text);
  return text + "\n";
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
