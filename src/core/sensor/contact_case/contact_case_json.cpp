#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/limits.h"
#include "core/base/text/json.h"
#include "core/base/text/law_json.h"
#include "core/layout/words.h"
#include "core/sensor/contact_case/case_objects.h"
#include "core/sensor/contact_case/contact_case.h"

namespace taxel {
namespace {

using Json = nlohmann::json;
using Node = JsonNode<Json>;

struct ShapeWord {
  const char* word;
  ShapeType type;
  std::size_t sizes;  ///< number of values of its size
};
constexpr std::array<ShapeWord, 9> kShapes{{{"plane", ShapeType::plane, 0},
                                            {"sphere", ShapeType::sphere, 1},
                                            {"capsule", ShapeType::capsule, 2},
                                            {"ellipsoid", ShapeType::ellipsoid, 3},
                                            {"cylinder", ShapeType::cylinder, 2},
                                            {"box", ShapeType::box, 3},
                                            {"mesh", ShapeType::mesh, 0},
                                            {"tets", ShapeType::tets, 0},
                                            {"hfield", ShapeType::mesh, 0}}};

ShapeWord parse_type(const Node& node) {
  const std::string word = node.text();
  std::string words;
  for (const ShapeWord& entry : kShapes) {
    if (word == entry.word) return entry;
    words += fmt::format("{}\"{}\"", words.empty() ? "" : ", ", entry.word);
  }
  node.wrong(fmt::format("one of {}", words));
}

/// Throws Error for a length or a coordinate that is farther than any vertex may be.
void must_be_near(const Node& node, double length) {
  if (std::abs(length) > kFarthest) node.fail(fmt::format("must be at most {:g} m, is {}", kFarthest, length));
}

/// Reads the lengths of a shape, which are positive.
std::vector<double> parse_lengths(const Node& node, std::size_t count) {
  std::vector<double> lengths = node.numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    must_be_positive(node.item(i), lengths[i]);
    must_be_near(node.item(i), lengths[i]);
  }
  return lengths;
}

/// Reads MuJoCo's height field: size x, y, z and base; elevations by rows along y, as fractions of z.
HeightField parse_height_field(const Node& node) {
  node.only({"type", "size", "elevation"});
  HeightField field;
  const std::vector<double> values = parse_lengths(node.at("size"), 4);
  field.size = {values[0], values[1], values[2]};
  field.base = values[3];
  const Node elevation = node.at("elevation");
  field.rows = static_cast<int>(elevation.length());
  if (field.rows < 2) elevation.wrong("an array of 2 rows or more");
  for (int r = 0; r < field.rows; ++r) {
    const Node row = elevation.item(static_cast<std::size_t>(r));
    if (r == 0) field.columns = static_cast<int>(row.length());
    if (field.columns < 2) row.wrong("an array of 2 numbers or more");
    for (const double e : row.numbers(static_cast<std::size_t>(field.columns))) {
      if (!(e >= 0 && e <= 1)) row.fail(fmt::format("must be between 0 and 1, is {}", e));
      field.elevation.push_back(e);
    }
  }
  return field;
}

CaseShape parse_shape(const Node& node) {
  const ShapeWord word = parse_type(node.at("type"));
  CaseShape shape;
  shape.type = word.type;
  if (std::string_view(word.word) == "hfield") {
    shape.height_field = parse_height_field(node);
    return shape;
  }
  node.only({"type", "size", "file", "scale", "repair"});
  if (const auto repair = node.find("repair")) {
    if (word.type != ShapeType::mesh) node.fail_at("repair", fmt::format("a {} needs no repair", word.word));
    shape.repair = repair->word<TouchedRepair>();
  }
  const bool from_file = word.type == ShapeType::mesh || word.type == ShapeType::tets;
  for (const char* key : {"file", "scale"}) {
    if (!from_file && node.find(key)) node.fail_at(key, fmt::format("a {} is not read from a file", word.word));
  }
  if (from_file) {
    if (node.find("size")) node.fail_at("size", fmt::format("a {} takes its size from its file; use scale", word.word));
    shape.file = node.at("file").text();
    if (const auto scale = node.find("scale")) {
      shape.scale = scale->vector3();
      if (shape.scale.x * shape.scale.y * shape.scale.z == 0) scale->fail("must not be 0");
    }
  } else if (word.sizes > 0) {
    const std::vector<double> values = parse_lengths(node.at("size"), word.sizes);
    for (std::size_t i = 0; i < values.size(); ++i) shape.size[static_cast<int>(i)] = values[i];
  }
  return shape;
}

Material parse_material(const Node& node, ShapeType type) {
  node.only({"field", "modulus", "thickness", "dissipation", "friction", "faces", "law"});
  Material material;
  material.field = type == ShapeType::mesh   ? FieldKind::pad
                   : type == ShapeType::tets ? FieldKind::tets
                                             : FieldKind::medial_axis;
  if (const auto field = node.find("field")) {
    const std::optional<FieldKind> kind = from_word<FieldKind>(field->text());
    if (!kind) field->wrong(fmt::format("one of {}", word_list<FieldKind>()));
    material.field = *kind;
  }
  if (const auto faces = node.find("faces")) {
    const std::optional<FaceRule> rule = from_word<FaceRule>(faces->text());
    if (!rule) faces->wrong(fmt::format("one of {}", word_list<FaceRule>()));
    material.faces = *rule;
  }
  const auto read = [&](const char* key, double& value) {
    if (const auto number = node.find(key)) {
      value = number->number();
      must_not_be_negative(*number, value);
    }
  };
  read("modulus", material.modulus);
  if (material.modulus > kMaxModulus)
    node.fail_at("modulus", fmt::format("must be at most {:g} Pa, is {}", kMaxModulus, material.modulus));
  read("thickness", material.thickness);
  if (const auto thickness = node.find("thickness")) must_be_near(*thickness, material.thickness);
  read("dissipation", material.dissipation);
  read("friction", material.friction);
  if (const auto law = node.find("law")) material.law = read_law(*law);
  return material;
}

/// Reads w x y z. A unit quaternion keeps its bits.
dquat parse_quaternion(const Node& node) {
  const std::vector<double> v = node.numbers(4);
  const double squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
  if (!(squared > 0)) node.fail("must not be zero");
  if (!std::isfinite(squared)) node.fail("is out of range");
  return unit_quaternion(v[0], v[1], v[2], v[3]);
}

CaseBody parse_body(const Node& node) {
  node.only(
      {"name", "shape", "layout", "resolution", "material", "pos", "quat", "linear_velocity", "angular_velocity"});
  CaseBody body;
  if (const auto layout = node.find("layout")) {
    for (const char* key : {"shape", "material", "resolution"}) {
      if (node.find(key)) node.fail_at(key, "a layout brings its own shape and material");
    }
    body.layout = layout->text();
    if (body.layout.empty()) layout->fail("must name a file");
  }
  if (const auto shape = node.find("shape")) {
    body.shape = parse_shape(*shape);
    if (const auto resolution = node.find("resolution")) {
      body.shape->resolution = resolution->number();
      must_be_positive(*resolution, body.shape->resolution);
      must_be_near(*resolution, body.shape->resolution);
    }
    if (const auto material = node.find("material")) body.material = parse_material(*material, body.shape->type);
  }
  if (const auto pos = node.find("pos")) {
    body.X_WB.p = pos->vector3();
    for (std::size_t i = 0; i < 3; ++i) must_be_near(pos->item(i), body.X_WB.p[static_cast<int>(i)]);
  }
  if (const auto quat = node.find("quat")) body.X_WB.q = parse_quaternion(*quat);
  if (const auto velocity = node.find("linear_velocity")) body.V_WB.linear = velocity->vector3();
  if (const auto velocity = node.find("angular_velocity")) body.V_WB.angular = velocity->vector3();
  return body;
}

}  // namespace

ContactCase parse_contact_case(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.only({"format", "version", "name", "a", "b"});
  const std::string format = root.at("format").text();
  if (format != "contact-case") root.at("format").wrong("\"contact-case\"");
  const double version = root.at("version").number();
  if (version != 1) root.fail_at("version", fmt::format("{} is unknown, this program reads version 1", version));
  ContactCase contact_case;
  contact_case.a = parse_body(root.at("a"));
  contact_case.b = parse_body(root.at("b"));
  contact_case.file = file;
  return contact_case;
}

ContactCase parse_case_object(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  ContactCase contact_case;
  contact_case.file = file;
  contact_case.b = parse_body(root);
  if (!contact_case.b.shape) root.fail_at("shape", "is missing: the object must be a shape");
  return contact_case;
}

ContactCase read_contact_case(const std::filesystem::path& path) {
  return parse_contact_case(read_file(path), path.string());
}

}  // namespace taxel
