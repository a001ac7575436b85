// Reading layout files: every value is taken through a reader that knows where in the document it stands.
#include "core/layout/layout_json.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/json_text.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
/// A value for messages: short values as they are, long ones by their kind.
std::string shown(const Json& value) {
  const std::string text = json_line(value);
  if (text.size() <= 60) return text;
  return value.is_object() ? "an object" : value.is_array() ? "an array" : "a long " + std::string(value.type_name());
}

/// What all readers of one document share.
struct Document {
  std::string file;
  std::map<std::string, std::string> unknown;
};

/// One JSON value and the pointer to it.
class Value {
 public:
  Value(const Json& json, std::string pointer, Document& document)
      : json_(json), pointer_(std::move(pointer)), document_(document) {}

  [[noreturn]] void fail(const std::string& expected) const {
    throw Error(document_.file, pointer_, fmt::format("must be {}, is {}", expected, shown(json_)));
  }
  [[nodiscard]] double number() const {
    if (!json_.is_number()) fail("a number");
    return json_.get<double>();
  }
  [[nodiscard]] bool flag() const {
    if (!json_.is_boolean()) fail("true or false");
    return json_.get<bool>();
  }
  [[nodiscard]] bool is_text() const { return json_.is_string(); }
  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("a text");
    return json_.get<std::string>();
  }
  [[nodiscard]] std::uint64_t natural() const {
    if (json_.is_number_unsigned()) return json_.get<std::uint64_t>();
    const double exact_limit = 0x1.0p53;
    const double v = json_.is_number_float() ? json_.get<double>() : -1.0;
    if (!(v >= 0.0 && v <= exact_limit && v == std::floor(v))) fail("a whole number, 0 or more");
    return static_cast<std::uint64_t>(v);
  }
  [[nodiscard]] int small_integer() const {
    const double v = json_.is_number() ? json_.get<double>() : 0.5;
    const double limit = std::numeric_limits<int>::max();
    if (!(v == std::floor(v) && std::abs(v) <= limit)) fail("a whole number of at most 31 bits");
    return static_cast<int>(v);
  }
  [[nodiscard]] dvec3 vector() const {
    if (!json_.is_array() || json_.size() != 3) fail("an array of 3 numbers");
    return {item(0).number(), item(1).number(), item(2).number()};
  }
  template <class E>
  [[nodiscard]] E word() const {
    if (!json_.is_string()) fail("a text");
    const std::optional<E> value = from_word<E>(json_.get<std::string>());
    if (!value) fail("one of " + word_list<E>());
    return *value;
  }
  [[nodiscard]] std::size_t array_size() const {
    if (!json_.is_array()) fail("an array");
    return json_.size();
  }
  [[nodiscard]] Value item(std::size_t i) const { return {json_[i], fmt::format("{}/{}", pointer_, i), document_}; }

 protected:
  const Json& json_;
  std::string pointer_;
  Document& document_;
};

/// An object whose keys are taken one by one; what is left over at the end is kept as unknown.
class Object : public Value {
 public:
  explicit Object(const Value& value) : Value(value) {
    if (!json_.is_object()) fail("an object");
  }
  /// Calls take(value) where the key stands; the default stays otherwise.
  template <class Take>
  void optional(const char* key, const Take& take) {
    known_.insert(key);
    const auto found = json_.find(key);
    if (found != json_.end()) take(Value(*found, pointer_ + "/" + key, document_));
  }
  [[nodiscard]] Value required(const char* key) {
    known_.insert(key);
    const auto found = json_.find(key);
    if (found == json_.end()) throw Error(document_.file, pointer_ + "/" + key, "is missing");
    return {*found, pointer_ + "/" + key, document_};
  }
  void number(const char* key, std::optional<double>& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void number(const char* key, double& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void vector(const char* key, dvec3& out) {
    optional(key, [&](const Value& v) { out = v.vector(); });
  }
  void text(const char* key, std::string& out) {
    optional(key, [&](const Value& v) { out = v.text(); });
  }
  template <class E>
  void word(const char* key, E& out) {
    optional(key, [&](const Value& v) { out = v.word<E>(); });
  }
  void keep_unknown() const {
    for (const auto& [key, value] : json_.items())
      if (!known_.contains(key)) document_.unknown[pointer_ + "/" + escaped_key(key)] = json_line(value);
  }

 private:
  std::set<std::string> known_;
};

void read_head(Object& root, const std::string& file) {
  const std::string format = root.required("format").text();
  if (format != "taxel-layout")
    throw Error(file, "/format", fmt::format("must be \"taxel-layout\", is {}", shown(Json(format))));
  const Value version = root.required("version");
  const double v = version.number();
  if (v != kVersion)
    throw Error(file, "/version", fmt::format("{} is unknown, this program reads version {}", v, kVersion));
}

MeshRef read_mesh(const Value& value) {
  Object object(value);
  MeshRef mesh;
  mesh.file = object.required("file").text();
  object.vector("scale", mesh.scale);
  object.text("sha256", mesh.sha256);
  object.keep_unknown();
  return mesh;
}

void read_settings(Object& root, Layout& layout) {
  root.optional("frame", [&](const Value& value) {
    Object object(value);
    object.vector("distal", layout.frame.distal);
    object.vector("pad", layout.frame.pad);
    object.keep_unknown();
  });
  root.optional("sampling", [&](const Value& value) {
    Object object(value);
    object.number("density", layout.sampling.density);
    object.optional("seed", [&](const Value& v) { layout.sampling.seed = v.natural(); });
    object.word("weights", layout.sampling.weights);
    object.word("shells", layout.sampling.shells);
    object.keep_unknown();
  });
  root.optional("receptive_field", [&](const Value& value) {
    Object object(value);
    object.word("metric", layout.receptive_field.metric);
    object.number("max_angle_deg", layout.receptive_field.max_angle_deg);
    object.keep_unknown();
  });
  root.optional("readout", [&](const Value& value) {
    Object object(value);
    object.word("aggregate", layout.readout.aggregate);
    object.word("misses", layout.readout.misses);
    object.word("ray", layout.readout.ray);
    object.number("max_depth", layout.readout.max_depth);
    object.optional("shear", [&](const Value& v) { layout.readout.shear = v.flag(); });
    object.keep_unknown();
  });
  root.optional("material", [&](const Value& value) {
    Object object(value);
    object.word("field", layout.material.field);
    object.number("modulus", layout.material.modulus);
    object.number("thickness", layout.material.thickness);
    object.number("dissipation", layout.material.dissipation);
    object.number("friction", layout.material.friction);
    object.keep_unknown();
  });
}

Subtaxel read_subtaxel(const Value& value) {
  Object object(value);
  Subtaxel subtaxel;
  subtaxel.center = object.required("center").vector();
  subtaxel.normal = object.required("normal").vector();
  subtaxel.radius = object.required("radius").number();
  object.keep_unknown();
  return subtaxel;
}

Taxel read_taxel(const Value& value, std::size_t index) {
  Object object(value);
  Taxel taxel;
  taxel.id = static_cast<int>(index);
  object.optional("id", [&](const Value& v) { taxel.id = v.small_integer(); });
  object.text("name", taxel.name);
  taxel.center = object.required("center").vector();
  taxel.normal = object.required("normal").vector();
  taxel.radius = object.required("radius").number();
  object.optional("subtaxels", [&](const Value& v) {
    for (std::size_t i = 0; i < v.array_size(); ++i) taxel.subtaxels.push_back(read_subtaxel(v.item(i)));
  });
  object.keep_unknown();
  return taxel;
}

Curve read_curve(const Value& value) {
  if (value.array_size() < 2) value.fail("an array of 2 points or more");
  Curve curve;
  for (std::size_t i = 0; i < value.array_size(); ++i) {
    const Value point = value.item(i);
    if (point.array_size() != 2) point.fail("an array of 2 numbers");
    curve.push_back({point.item(0).number(), point.item(1).number()});
  }
  return curve;
}

TaxelCalibration read_taxel_calibration(const Value& value, const std::string& file) {
  Object object(value);
  TaxelCalibration taxel;
  taxel.id = object.required("id").small_integer();
  try {
    object.number("tare", taxel.tare);
    object.number("gain", taxel.gain);
    object.optional("curve", [&](const Value& v) { taxel.curve = read_curve(v); });
    object.number("dead", taxel.dead);
  } catch (const Error& e) {
    throw Error(file, e.where(), fmt::format("{} (taxel {})", e.message(), taxel.id));
  }
  object.keep_unknown();
  return taxel;
}

/// The parts that are objects of their own.
void read_calibration_parts(Object& object, Calibration& calibration) {
  object.optional("hysteresis", [&](const Value& value) {
    Object part(value);
    Hysteresis& hysteresis = calibration.hysteresis.emplace();
    hysteresis.width = part.required("width").number();
    part.number("fraction", hysteresis.fraction);
    part.keep_unknown();
  });
  object.optional("crosstalk", [&](const Value& value) {
    Object part(value);
    calibration.crosstalk = {part.required("fraction").number(), part.required("reach").number()};
    part.keep_unknown();
  });
  object.optional("quantisation", [&](const Value& value) {
    Object part(value);
    Quantisation& quantisation = calibration.quantisation.emplace();
    part.number("step", quantisation.step);
    part.optional("bits", [&](const Value& v) { quantisation.bits = v.small_integer(); });
    part.keep_unknown();
  });
  object.optional("dead", [&](const Value& value) {
    Object part(value);
    DeadTaxels& dead = calibration.dead.emplace();
    dead.fraction = part.required("fraction").number();
    part.number("value", dead.value);
    part.keep_unknown();
  });
}

Calibration read_calibration(const Value& value, const std::string& file) {
  Object object(value);
  Calibration calibration;
  object.optional("seed", [&](const Value& v) { calibration.seed = v.natural(); });
  object.text("unit", calibration.unit);
  read_calibration_parts(object, calibration);
  object.optional("tare", [&](const Value& v) {
    if (v.is_text() && v.text() != "first_reading") v.fail("a number or \"first_reading\"");
    calibration.tare = v.is_text() ? Tare{true, 0.0} : Tare{false, v.number()};
  });
  object.number("tare_deviation", calibration.tare_deviation);
  object.number("gain", calibration.gain);
  object.optional("curve", [&](const Value& v) { calibration.curve = read_curve(v); });
  object.number("gain_deviation", calibration.gain_deviation);
  object.number("noise", calibration.noise);
  object.optional("range", [&](const Value& v) {
    if (v.array_size() != 2) v.fail("an array of 2 numbers");
    calibration.range = {v.item(0).number(), v.item(1).number()};
  });
  object.number("rate", calibration.rate);
  object.optional("taxels", [&](const Value& v) {
    for (std::size_t i = 0; i < v.array_size(); ++i)
      calibration.taxels.push_back(read_taxel_calibration(v.item(i), file));
  });
  object.keep_unknown();
  return calibration;
}

}  // namespace

Layout parse_layout(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  Document document{file, {}};
  Object root(Value(json, "", document));
  read_head(root, file);

  Layout layout;
  root.text("name", layout.name);
  if (!json.contains("mesh")) throw Error(file, "/mesh/file", "is missing");
  layout.mesh = read_mesh(root.required("mesh"));
  read_settings(root, layout);
  const Value taxels = root.required("taxels");
  for (std::size_t i = 0; i < taxels.array_size(); ++i) layout.taxels.push_back(read_taxel(taxels.item(i), i));
  root.optional("calibration", [&](const Value& value) { layout.calibration = read_calibration(value, file); });
  root.keep_unknown();
  layout.unknown = std::move(document.unknown);
  return layout;
}

Layout read_layout(const std::filesystem::path& path) {
  return parse_layout(read_file(path), path.string());
}

std::filesystem::path mesh_path(const Layout& layout, const std::filesystem::path& layout_file) {
  const std::filesystem::path mesh(layout.mesh.file);
  return mesh.is_absolute() ? mesh : (layout_file.parent_path() / mesh).lexically_normal();
}

}  // namespace taxel
