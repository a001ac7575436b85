#include "core/sim/scene/old_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/mesh/primitives.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/mujoco_vectors.h"
#include "core/sim/scene/xml_attributes.h"

namespace taxel {
namespace {

constexpr std::string_view kPrefix = "cs::";
constexpr double kPitch = 0.025;            // [m]
constexpr double kSamplesPerTaxel = 100.0;  // in a square of the pitch

/// What a numeric says, the rest zero.
std::vector<double> numbers_of(const mjModel& m, int numeric) {
  const mjtNum* first = m.numeric_data + m.numeric_adr[numeric];
  std::vector<double> numbers(first, first + m.numeric_size[numeric]);
  numbers.resize(std::max<std::size_t>(numbers.size(), 5));
  return numbers;
}

/// Middles of as many equal parts as fit best.
std::vector<double> places(double half) {
  const int count = std::max(1, static_cast<int>(std::lround(2 * half / kPitch)));
  std::vector<double> middles;
  for (int i = 0; i < count; ++i) middles.push_back(half * ((2.0 * i + 1) / count - 1));
  return middles;
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
    if (mj_name2id(&m, mjOBJ_GEOM, geom.c_str()) >= 0) fields.geoms[geom] = {numbers[0], numbers[1], numbers[4]};
  }
  return fields;
}

std::string old_keys(const OldFields& fields, const std::string& geom) {
  if (!fields.geoms.contains(geom)) return "";
  std::string others, materials;
  for (const auto& [name, field] : fields.geoms) {
    if (name == geom) continue;
    others += (others.empty() ? "" : " ") + name;
    materials +=
        fmt::format(R"({}"{}": {{"modulus": {}, "dissipation": {}, "friction": {}}})", materials.empty() ? "" : ", ",
                    name, field.modulus, field.modulus > 0 ? field.dissipation : 0.0, field.friction);
  }
  if (others.empty()) return "";
  return fmt::format(R"(<config key="others" value="{}"/><config key="materials" value="{}"/>)", xml_escaped(others),
                     xml_escaped("{" + materials + "}")) +
         (fields.apply ? "" : R"(<config key="force" value="sense"/>)");
}

SensorModelPtr old_sensor(const mjModel& m, int geom, const OldField& field) {
  if (m.geom_type[geom] != mjGEOM_BOX) return nullptr;
  const dvec3 half = vec3(m.geom_size + 3 * geom);
  Layout layout;
  layout.name = geom_name(m, geom);
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
