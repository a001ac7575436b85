// Reads and writes taxels as JSON, equally for layout files and the clipboard.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "core/base/text/json_reader.h"
#include "core/layout/layout.h"

namespace taxel {

template <class Json>
Subtaxel read_subtaxel(const JsonNode<Json>& value) {
  JsonObject<Json> object(value);
  Subtaxel subtaxel;
  subtaxel.center = object.required("center").vector3();
  subtaxel.normal = object.required("normal").vector3();
  subtaxel.radius = object.required("radius").number();
  object.keep_unknown();
  return subtaxel;
}

/// Reads a taxel. `index` is its id if the object has none.
template <class Json>
Taxel read_taxel(const JsonNode<Json>& value, std::size_t index) {
  JsonObject<Json> object(value);
  Taxel taxel;
  taxel.id = static_cast<int>(index);
  object.optional("id", [&](const JsonNode<Json>& v) { taxel.id = v.small_integer(); });
  object.text("name", taxel.name);
  taxel.center = object.required("center").vector3();
  taxel.normal = object.required("normal").vector3();
  taxel.radius = object.required("radius").number();
  object.optional("subtaxels", [&](const JsonNode<Json>& v) {
    for (std::size_t i = 0; i < v.length(); ++i) taxel.subtaxels.push_back(read_subtaxel(v.item(i)));
  });
  object.number("density", taxel.density);
  object.keep_unknown();
  return taxel;
}

/// Writes the three values that taxels and subtaxels share.
template <class Json, class T>
void write_disc(Json& json, const T& disc, const std::string& pointer) {
  json["center"] = json_vector<Json>(disc.center, pointer + "/center");
  json["normal"] = json_vector<Json>(disc.normal, pointer + "/normal");
  json["radius"] = json_number<Json>(disc.radius, pointer + "/radius");
}

template <class Json>
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

}  // namespace taxel
