#include "core/sim/scene/old_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/mesh/make/primitives.h"
#include "core/sim/model/geometry.h"
#include "core/sim/scene/mjcf_text.h"

namespace taxel {
namespace {

constexpr std::string_view kPrefix = "cs::";
constexpr double kPitch = 0.025;            // [m]
constexpr double kSamplesPerTaxel = 100.0;  // samples in a square whose side is the pitch

/// Largest number of taxels on one box. Each taxel has kSamplesPerTaxel samples.
constexpr int kMaxFieldTaxels = 4096;

/// Returns the numbers of a numeric, at least five; missing numbers are 0.
std::vector<double> numbers_of(const mjModel& m, int numeric) {
  const mjtNum* first = m.numeric_data + m.numeric_adr[numeric];
  std::vector<double> numbers(first, first + m.numeric_size[numeric]);
  numbers.resize(std::max<std::size_t>(numbers.size(), 5));
  return numbers;
}

/// Divides [-half, half] into equal parts whose length is closest to the pitch, and returns the middles of the parts.
std::vector<double> places(double half) {
  const int count = std::max(1, static_cast<int>(std::lround(2 * half / kPitch)));
  std::vector<double> middles;
  for (int i = 0; i < count; ++i) middles.push_back(half * ((2.0 * i + 1) / count - 1));
  return middles;
}

/// Returns the name of a type of geom that can only be rigid, or null for other types.
const char* rigid_only(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return "a plane without thickness";
    case mjGEOM_HFIELD:
      return "a height field";
    case mjGEOM_SDF:
      return "a signed distance function";
    default:
      return nullptr;
  }
}

/// Returns the edge length of a round geom [m], or 0 for the automatic choice, a tenth of the smallest extent. The hint
/// of the field is used if it is finer than this choice, but not below a quarter of it.
double resolution_of(const mjModel& m, int geom, const OldField& field) {
  const mjtNum* size = m.geom_size + 3 * geom;
  double radius = 0;
  if (m.geom_type[geom] == mjGEOM_SPHERE || m.geom_type[geom] == mjGEOM_CAPSULE) radius = size[0];
  if (m.geom_type[geom] == mjGEOM_CYLINDER) radius = std::min(size[0], size[1]);
  if (m.geom_type[geom] == mjGEOM_ELLIPSOID) radius = std::min({size[0], size[1], size[2]});
  const double ours = 0.2 * radius;
  return field.resolution > 0 && field.resolution < ours ? std::max(field.resolution, 0.25 * ours) : 0;
}

/// Returns `"name": {material}` in the format of the key "materials".
std::string material_json(const mjModel& m, const std::string& name, const OldField& field) {
  return fmt::format(R"("{}": {{"modulus": {}, "dissipation": {}, "friction": {}, "resolution": {}}})", name,
                     field.modulus, field.modulus > 0 ? field.dissipation : 0.0, field.friction,
                     resolution_of(m, mj_name2id(&m, mjOBJ_GEOM, name.c_str()), field));
}

std::string config(const char* key, const std::string& value) {
  return fmt::format(R"(<config key="{}" value="{}"/>)", key, xml_escaped(value));
}

}  // namespace

OldFields old_fields(const mjModel& m) {
  OldFields fields;
  for (int n = 0; n < m.nnumeric; ++n) {
    const std::string_view name = m.names + m.name_numericadr[n];
    if (!name.starts_with(kPrefix)) continue;
    const std::string geom(name.substr(kPrefix.size()));
    const std::vector<double> numbers = numbers_of(m, n);
    if (geom == "ApplyContactSurfaceForces") fields.apply = numbers[0] != 0;
    const int id = mj_name2id(&m, mjOBJ_GEOM, geom.c_str());
    if (id < 0) continue;
    OldField field{numbers[0], numbers[1], numbers[2], numbers[4]};
    const char* const what = rigid_only(m.geom_type[id]);
    if (what != nullptr && field.modulus > 0) {
      fields.notes.push_back(
          fmt::format("field \"cs::{0}\" makes geom \"{0}\" soft, which is {1}: it is rigid", geom, what));
      field.modulus = 0;
    }
    fields.geoms[geom] = field;
  }
  return fields;
}

std::string old_keys(const mjModel& m, const OldFields& fields, const std::string& geom) {
  if (!fields.geoms.contains(geom)) return "";
  std::vector<std::string> others, materials;
  for (const auto& [name, field] : fields.geoms) {
    if (name == geom) continue;
    others.push_back(name);
    materials.push_back(material_json(m, name, field));
  }
  if (others.empty()) return "";
  return config("others", fmt::format("{}", fmt::join(others, " "))) +
         config("materials", fmt::format("{{{}}}", fmt::join(materials, ", "))) +
         (fields.apply ? "" : config("force", "sense"));
}

std::string old_contact_keys(const mjModel& m, const OldFields& fields, const std::vector<std::string>& sensing) {
  std::vector<std::string> materials, pairs;
  for (const auto& [name, field] : fields.geoms) {
    if (std::find(sensing.begin(), sensing.end(), name) != sensing.end()) continue;
    materials.push_back(material_json(m, name, field));
    for (const auto& [other, other_field] : fields.geoms) {
      if (other <= name || std::find(sensing.begin(), sensing.end(), other) != sensing.end()) continue;
      const int a = mj_name2id(&m, mjOBJ_GEOM, name.c_str()), b = mj_name2id(&m, mjOBJ_GEOM, other.c_str());
      if ((field.modulus > 0 || other_field.modulus > 0) && would_collide(m, a, b)) pairs.push_back(name + " " + other);
    }
  }
  if (pairs.empty()) return "";
  return config("materials", fmt::format("{{{}}}", fmt::join(materials, ", "))) +
         config("pairs", fmt::format("{}", fmt::join(pairs, ", "))) + (fields.apply ? "" : config("force", "sense"));
}

SensorModelPtr old_sensor(const mjModel& m, int geom, const OldField& field) {
  if (m.geom_type[geom] != mjGEOM_BOX) return nullptr;
  const dvec3 half = vec3(m.geom_size + 3 * geom);
  Layout layout;
  layout.name = geom_name(m, geom);
  const double taxels = std::ceil(2 * half.x / kPitch) * std::ceil(2 * half.y / kPitch);
  if (taxels > kMaxFieldTaxels)
    throw Error("", fmt::format("field \"cs::{}\"", layout.name),
                fmt::format("a box of {} m by {} m would get {:.3g} taxels, one for each {} m, at most {} are made: is "
                            "the size in metres?",
                            2 * half.x, 2 * half.y, taxels, kPitch, kMaxFieldTaxels));
  layout.mesh.file = layout.name;
  layout.frame = {{1, 0, 0}, {0, 0, 1}};
  layout.material = {FieldKind::pad, field.modulus, std::min({half.x, half.y, half.z}), field.dissipation,
                     field.friction};
  layout.sampling.density = kSamplesPerTaxel / (kPitch * kPitch);
  for (const double x : places(half.x)) {
    for (const double y : places(half.y)) {
      Taxel taxel;
      taxel.id = static_cast<int>(layout.taxels.size());
      taxel.center = {x, y, half.z};
      taxel.radius = 0.5 * kPitch;
      layout.taxels.push_back(taxel);
    }
  }
  return build_sensor_model(layout, std::make_shared<const TriMesh>(make_box(half)), "", layout.name);
}

}  // namespace taxel
