// Parsing of the plugin key `materials`, which gives materials to geoms by name.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/text/json.h"
#include "core/base/text/law_json.h"
#include "core/layout/words.h"
#include "core/sim/plugin/materials.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

OtherMaterial parse_material(const Node& node) {
  node.only({"field", "modulus", "thickness", "dissipation", "friction", "faces", "law", "resolution", "repair"});
  OtherMaterial other;
  const auto read = [&](const char* key, double& value) {
    const auto number = node.find(key);
    if (!number) return false;
    value = number->number();
    must_not_be_negative(*number, value);
    return true;
  };
  read("modulus", other.material.modulus);
  read("thickness", other.material.thickness);
  read("dissipation", other.material.dissipation);
  read("resolution", other.resolution);
  other.has_friction = read("friction", other.material.friction);
  if (const auto field = node.find("field")) {
    other.material.field = field->word<FieldKind>();
    other.has_field = true;
  }
  if (const auto faces = node.find("faces")) other.material.faces = faces->word<FaceRule>();
  if (const auto law = node.find("law")) other.material.law = read_law(*law);
  if (const auto repair = node.find("repair")) other.repair = repair->word<TouchedRepair>();
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
