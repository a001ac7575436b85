// Writes layout files: fixed key order, unknown keys at their old places, one form for every number.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/json_text.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/file/taxel_value.h"
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

/// Writes only the values that are set. The default of a number that is not set depends on the mesh.
Json repair_json(const RepairRecipe& recipe) {
  Json json = Json::object();
  if (recipe.level != RepairLevel::automatic) json["level"] = word(recipe.level);
  for (const RepairNumber& n : kRepairNumbers)
    if (const std::optional<double>& value = recipe.*n.value)
      json[n.key] = number(*value, fmt::format("/mesh/repair/{}", n.key));
  return json;
}

/// Returns true if /mesh/repair has unknown keys, which need its object.
bool has_unknown_repair_keys(const Layout& layout) {
  const std::string start = "/mesh/repair/";
  const auto first = layout.unknown.lower_bound(start);
  return first != layout.unknown.end() && first->first.starts_with(start);
}

Json receptive_field_json(const ReceptiveFieldRule& rule) {
  Json json = {{"metric", word(rule.metric)},
               {"max_angle_deg", number(rule.max_angle_deg, "/receptive_field/max_angle_deg")}};
  if (rule.angle_falloff_deg != 0.0)
    json["angle_falloff_deg"] = number(rule.angle_falloff_deg, "/receptive_field/angle_falloff_deg");
  if (rule.normals != FieldNormals::face) json["normals"] = word(rule.normals);
  return json;
}

Json readout_json(const Readout& readout) {
  Json json = {{"aggregate", word(readout.aggregate)}};
  if (readout.method != ReadingMethod::samples) json["method"] = word(readout.method);
  json["misses"] = word(readout.misses);
  json["ray"] = word(readout.ray);
  json["max_depth"] = number(readout.max_depth, "/readout/max_depth");
  if (readout.shear) json["shear"] = true;
  return json;
}

Json material_json(const Material& material) {
  Json json = {{"field", word(material.field)},
               {"modulus", number(material.modulus, "/material/modulus")},
               {"thickness", number(material.thickness, "/material/thickness")},
               {"dissipation", number(material.dissipation, "/material/dissipation")},
               {"friction", number(material.friction, "/material/friction")}};
  if (material.faces != Material().faces) json["faces"] = word(material.faces);
  if (material.tangential_stiffness != 0.0)
    json["tangential_stiffness"] = number(material.tangential_stiffness, "/material/tangential_stiffness");
  if (material.bristles != Material().bristles) json["bristles"] = material.bristles;
  return json;
}

void write_settings(Json& json, const Layout& layout) {
  json["mesh"] = {
      {"file", layout.mesh.file}, {"scale", vector(layout.mesh.scale, "/mesh/scale")}, {"sha256", layout.mesh.sha256}};
  const Json repair = repair_json(layout.mesh.repair);
  if (!repair.empty() || has_unknown_repair_keys(layout)) json["mesh"]["repair"] = repair;
  json["frame"] = {{"distal", vector(layout.frame.distal, "/frame/distal")},
                   {"pad", vector(layout.frame.pad, "/frame/pad")}};
  json["sampling"] = {{"density", number(layout.sampling.density, "/sampling/density")},
                      {"seed", layout.sampling.seed},
                      {"weights", word(layout.sampling.weights)}};
  if (layout.sampling.shells != Shells::outer) json["sampling"]["shells"] = word(layout.sampling.shells);
  if (!layout.sampling.region->empty()) json["sampling"]["region"] = region_json(*layout.sampling.region);
  json["receptive_field"] = receptive_field_json(layout.receptive_field);
  json["readout"] = readout_json(layout.readout);
  json["material"] = material_json(layout.material);
}

Json curve_json(const Curve& curve, const std::string& pointer) {
  Json json = Json::array();
  for (std::size_t i = 0; i < curve.size(); ++i)
    json.push_back(Json::array({number(curve[i].reading, fmt::format("{}/{}/0", pointer, i)),
                                number(curve[i].value, fmt::format("{}/{}/1", pointer, i))}));
  return json;
}

/// A JSON object with the values that are set.
class Sparse {
 public:
  explicit Sparse(std::string pointer) : pointer_(std::move(pointer)) {}
  void put(const char* key, double v) { json[key] = number(v, pointer_ + "/" + key); }
  void put(const char* key, const std::optional<double>& v) {
    if (v) put(key, *v);
  }
  void put_unless_zero(const char* key, double v) {
    if (v != 0.0) put(key, v);
  }
  void put(const char* key, const Curve& curve) {
    if (!curve.empty()) json[key] = curve_json(curve, pointer_ + "/" + key);
  }
  [[nodiscard]] Sparse part(const char* key) const { return Sparse(pointer_ + "/" + key); }
  Json json = Json::object();

 private:
  std::string pointer_;
};

/// Returns the parts of a layout that are JSON objects.
void write_calibration_parts(Sparse& out, const Calibration& calibration) {
  if (calibration.hysteresis) {
    Sparse part = out.part("hysteresis");
    part.put("width", calibration.hysteresis->width);
    part.put("fraction", calibration.hysteresis->fraction);
    out.json["hysteresis"] = part.json;
  }
  if (calibration.crosstalk) {
    Sparse part = out.part("crosstalk");
    part.put("fraction", calibration.crosstalk->fraction);
    part.put("reach", calibration.crosstalk->reach);
    out.json["crosstalk"] = part.json;
  }
  if (calibration.quantisation) {
    Sparse part = out.part("quantisation");
    part.put("step", calibration.quantisation->step);
    if (calibration.quantisation->bits) part.json["bits"] = *calibration.quantisation->bits;
    out.json["quantisation"] = part.json;
  }
  if (calibration.dead) {
    Sparse part = out.part("dead");
    part.put("fraction", calibration.dead->fraction);
    part.put("value", calibration.dead->value);
    out.json["dead"] = part.json;
  }
}

Json calibration_json(const Calibration& calibration) {
  Sparse out("/calibration");
  out.json["seed"] = calibration.seed;
  if (!calibration.unit.empty()) out.json["unit"] = calibration.unit;
  write_calibration_parts(out, calibration);
  if (calibration.tare && calibration.tare->first_reading)
    out.json["tare"] = "first_reading";
  else if (calibration.tare)
    out.put("tare", calibration.tare->value);
  out.put_unless_zero("tare_deviation", calibration.tare_deviation);
  out.put("gain", calibration.gain);
  out.put("curve", calibration.curve);
  out.put_unless_zero("gain_deviation", calibration.gain_deviation);
  out.put_unless_zero("noise", calibration.noise);
  if (calibration.range)
    out.json["range"] = {number(calibration.range->low, "/calibration/range/0"),
                         number(calibration.range->high, "/calibration/range/1")};
  out.put("rate", calibration.rate);
  for (std::size_t i = 0; i < calibration.taxels.size(); ++i) {
    const TaxelCalibration& taxel = calibration.taxels[i];
    Sparse item(fmt::format("/calibration/taxels/{}", i));
    item.json["id"] = taxel.id;
    item.put("tare", taxel.tare);
    item.put("gain", taxel.gain);
    item.put("curve", taxel.curve);
    item.put("dead", taxel.dead);
    out.json["taxels"].push_back(item.json);
  }
  return out.json;
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
  write_settings(json, layout);
  json["taxels"] = Json::array();
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    json["taxels"].push_back(taxel_json<Json>(layout.taxels[i], fmt::format("/taxels/{}", i)));
  if (layout.calibration) json["calibration"] = calibration_json(*layout.calibration);
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
