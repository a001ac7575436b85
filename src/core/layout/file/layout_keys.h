// The keys that each object of a layout file may have (assets/schema/layout.schema.json lists the same ones), and files
// of earlier versions brought to the version that this program reads, one version at a time. The latter is a template
// over the JSON type, so that the library stays in the *_json.cpp files that use it.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace taxel {

/// Returns the keys of the object at a JSON pointer into a layout, such as "" (the whole file), "/mesh" or "/taxels/3".
/// Empty if a layout has no object there.
std::span<const std::string_view> known_layout_keys(std::string_view pointer);

inline constexpr int kLayoutVersion = 1;  ///< version that is written

/// Renames a key of an object, at its place. Throws Error with the object's pointer if the object has both keys.
/// Returns false if it has no such key.
template <class Json>
bool rename_key(Json& object, const std::string& from, const std::string& to, const std::string& pointer) {
  if (!object.is_object() || !object.contains(from)) return false;
  if (object.contains(to))
    throw Error("", pointer, fmt::format("has both \"{}\" (version 0) and \"{}\" (version 1): remove one", from, to));
  Json renamed = Json::object();
  for (auto& [key, value] : object.items()) renamed[key == from ? to : key] = std::move(value);
  object = std::move(renamed);
  return true;
}

/// Moves a key of the root into one of its objects, which is made if it is missing. Throws Error if the object has the
/// key already, or is no object. Returns false if the root has no such key.
template <class Json>
bool move_into(Json& root, const std::string& key, const std::string& object) {
  if (!root.contains(key)) return false;
  Json& into = root[object];
  if (into.is_null()) into = Json::object();
  if (!into.is_object()) throw Error("", "/" + object, "must be an object");
  if (into.contains(key))
    throw Error("", "/" + key, fmt::format("is also in \"{}\" (version 1): remove one of them", object));
  into[key] = std::move(root[key]);
  root.erase(key);
  return true;
}

/// Brings a layout of version 0, the draft before the first release, to version 1 (docs/layout_format.md, "Versions"):
/// adds one sentence to `notes` for each change. Values are moved as they are, whatever their type: the reader of
/// version 1 checks them at their new places.
template <class Json>
void migrate_from_0(Json& root, std::vector<std::string>& notes) {
  if (root.contains("mesh") && root["mesh"].is_string()) {
    root["mesh"] = Json{{"file", std::move(root["mesh"])}};
    notes.emplace_back("\"mesh\" is an object, and the file is \"mesh/file\"");
  }
  const std::pair<const char*, const char*> moves[] = {
      {"scale", "mesh"}, {"density", "sampling"}, {"seed", "sampling"}};
  for (const auto& [key, object] : moves) {
    if (!move_into(root, key, object)) continue;
    notes.push_back(fmt::format("\"{0}\" is \"{1}/{0}\"", key, object));
    Json& value = root[object][key];
    if (value.is_number() && std::string(object) == "mesh") value = Json::array({value, value, value});
  }
  int renamed = 0, filled = 0;
  if (root.contains("taxels") && root["taxels"].is_array()) {
    for (std::size_t i = 0; i < root["taxels"].size(); ++i) {
      Json& taxel = root["taxels"][i];
      const std::string pointer = fmt::format("/taxels/{}", i);
      const bool center = rename_key(taxel, "position", "center", pointer);
      const bool normal = rename_key(taxel, "direction", "normal", pointer);
      if (center || normal) ++renamed;
      if (!root.contains("radius") || !taxel.is_object() || taxel.contains("radius")) continue;
      taxel["radius"] = root["radius"];
      ++filled;
    }
  }
  if (renamed > 0)
    notes.push_back(fmt::format("\"position\" and \"direction\" of {} taxels are \"center\" and \"normal\"", renamed));
  if (root.contains("radius")) {
    notes.push_back(fmt::format("\"radius\" of the file is that of each of the {} taxels without one", filled));
    root.erase("radius");
  }
}

/// Brings a layout of an earlier version to kLayoutVersion. Returns one sentence for each change; none if the layout is
/// of that version. Throws Error(file, JSON pointer, message): the layout has a value both at its old and its new
/// place. A version that is not an earlier one is left to the reader.
template <class Json>
std::vector<std::string> migrate_layout(Json& root, const std::string& file) {
  using Migrate = void (*)(Json&, std::vector<std::string>&);
  constexpr Migrate kFrom[] = {migrate_from_0<Json>};  // from the version of its index to the next one
  static_assert(std::size(kFrom) == kLayoutVersion);
  std::vector<std::string> notes;
  if (!root.is_object() || !root.contains("version") || !root["version"].is_number()) return notes;
  const double version = root["version"].template get<double>();
  for (int from = 0; from < kLayoutVersion; ++from) {
    if (version != from) continue;
    notes.push_back(
        fmt::format("is of version {}: it is read as version {}, and will be saved as that", from, kLayoutVersion));
    try {
      for (int v = from; v < kLayoutVersion; ++v) kFrom[v](root, notes);
    } catch (const Error& e) {
      throw Error(file, e.where(), e.message());
    }
    root["version"] = kLayoutVersion;
  }
  return notes;
}

}  // namespace taxel
