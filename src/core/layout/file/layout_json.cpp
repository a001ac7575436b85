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

RepairRecipe read_repair(const Value& value) {
  Object object(value);
  RepairRecipe recipe;
  object.word("level", recipe.level);
  for (const RepairNumber& number : kRepairNumbers) object.number(number.key, recipe.*number.value);
  object.keep_unknown();
  return recipe;
}

MeshRef read_mesh(const Value& value) {
  Object object(value);
  MeshRef mesh;
  mesh.file = object.required("file").text();
  object.vector("scale", mesh.scale);
  object.text("sha256", mesh.sha256);
  object.optional("repair", [&](const Value& v) { mesh.repair = read_repair(v); });
  object.keep_unknown();
  return mesh;
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

void read_settings(Object& root, Layout& layout) {
  root.part("frame", [&](Object& object) {
    object.vector("distal", layout.frame.distal);
    object.vector("pad", layout.frame.pad);
  });
  root.part("sampling", [&](Object& object) {
    object.number("density", layout.sampling.density);
    object.optional("seed", [&](const Value& v) { layout.sampling.seed = v.natural(); });
    object.word("weights", layout.sampling.weights);
    object.word("shells", layout.sampling.shells);
    object.optional("region", [&](const Value& v) { layout.sampling.region = read_region(v); });
  });
  root.part("receptive_field", [&](Object& object) {
    object.word("metric", layout.receptive_field.metric);
    object.number("max_angle_deg", layout.receptive_field.max_angle_deg);
    object.number("angle_falloff_deg", layout.receptive_field.angle_falloff_deg);
    object.word("normals", layout.receptive_field.normals);
  });
  root.part("readout", [&](Object& object) {
    object.word("aggregate", layout.readout.aggregate);
    object.word("method", layout.readout.method);
    object.word("misses", layout.readout.misses);
    object.word("ray", layout.readout.ray);
    object.number("max_depth", layout.readout.max_depth);
    object.optional("shear", [&](const Value& v) { layout.readout.shear = v.flag(); });
  });
  root.part("material", [&](Object& object) {
    object.word("field", layout.material.field);
    object.number("modulus", layout.material.modulus);
    object.number("thickness", layout.material.thickness);
    object.number("dissipation", layout.material.dissipation);
    object.number("friction", layout.material.friction);
    object.word("faces", layout.material.faces);
    object.number("tangential_stiffness", layout.material.tangential_stiffness);
    object.optional("bristles", [&](const Value& v) { layout.material.bristles = v.small_integer(); });
  });
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

/// Reads the parts of a layout that are JSON objects.
void read_calibration_parts(Object& object, Calibration& calibration) {
  object.part("hysteresis", [&](Object& part) {
    Hysteresis& hysteresis = calibration.hysteresis.emplace();
    hysteresis.width = part.required("width").number();
    part.number("fraction", hysteresis.fraction);
  });
  object.part("crosstalk", [&](Object& part) {
    calibration.crosstalk = {part.required("fraction").number(), part.required("reach").number()};
  });
  object.part("quantisation", [&](Object& part) {
    Quantisation& quantisation = calibration.quantisation.emplace();
    part.number("step", quantisation.step);
    part.optional("bits", [&](const Value& v) { quantisation.bits = v.small_integer(); });
  });
  object.part("dead", [&](Object& part) {
    DeadTaxels& dead = calibration.dead.emplace();
    dead.fraction = part.required("fraction").number();
    part.number("value", dead.value);
  });
}

Calibration read_calibration(const Value& value, const std::string& file) {
  Object object(value);
  Calibration calibration;
  object.optional("seed", [&](const Value& v) { calibration.seed = v.natural(); });
  object.text("unit", calibration.unit);
  read_calibration_parts(object, calibration);
  object.optional("tare", [&](const Value& v) {
    if (v.is_text() && v.text() != "first_reading") v.wrong("a number or \"first_reading\"");
    calibration.tare = v.is_text() ? Tare{true, 0.0} : Tare{false, v.number()};
  });
  object.number("tare_deviation", calibration.tare_deviation);
  object.number("gain", calibration.gain);
  object.optional("curve", [&](const Value& v) { calibration.curve = read_curve(v); });
  object.number("gain_deviation", calibration.gain_deviation);
  object.number("noise", calibration.noise);
  object.optional("range", [&](const Value& v) {
    if (v.length() != 2) v.wrong("an array of 2 numbers");
    calibration.range = {v.item(0).number(), v.item(1).number()};
  });
  object.number("rate", calibration.rate);
  object.optional("taxels", [&](const Value& v) {
    for (std::size_t i = 0; i < v.length(); ++i) calibration.taxels.push_back(read_taxel_calibration(v.item(i), file));
  });
  object.keep_unknown();
  return calibration;
}

Layout layout_of(const Json& json, const std::string& file) {
  Layout layout;
  refuse_foreign(json, file);
  Object root(Value(json, file, &layout.unknown));
  read_head(root, file);
  root.text("name", layout.name);
  if (!json.contains("mesh")) throw Error(file, "/mesh/file", "is missing");
  layout.mesh = read_mesh(root.required("mesh"));
  read_settings(root, layout);
  const Value taxels = root.required("taxels");
  for (std::size_t i = 0; i < taxels.length(); ++i) layout.taxels.push_back(read_taxel(taxels.item(i), i));
  root.optional("calibration", [&](const Value& value) { layout.calibration = read_calibration(value, file); });
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
