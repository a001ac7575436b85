// The key `materials` of the plugin: geom name -> material.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/layout/words.h"
#include "core/project/strict_json.h"
#include "core/sim/plugin/sensor_config.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = StrictNode<Json>;

OtherMaterial parse_material(const Node& node) {
  node.only({"field", "modulus", "thickness", "dissipation", "friction", "resolution"});
  OtherMaterial other;
  const auto read = [&](const char* key, double& value) {
    const auto number = node.find(key);
    if (!number) return false;
    value = number->number();
    number->must_not_be_negative(value);
    return true;
  };
  read("modulus", other.material.modulus);
  read("thickness", other.material.thickness);
  read("dissipation", other.material.dissipation);
  read("resolution", other.resolution);
  other.has_friction = read("friction", other.material.friction);
  if (const auto field = node.find("field")) {
    const auto kind = from_word<FieldKind>(field->text());
    if (!kind) field->wrong(fmt::format("one of {}", word_list<FieldKind>()));
    other.material.field = *kind;
    other.has_field = true;
  }
  return other;
}

}  // namespace

OtherMaterials parse_materials(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  OtherMaterials materials;
  for (const auto& item : json.items()) materials[item.key()] = parse_material(root.at(item.key()));
  return materials;
}

}  // namespace taxel
