// Writes sensor descriptions of the predecessor's code, and their row of the table of formats.
#include <fmt/format.h>

#include <algorithm>

#include "core/layout/formats/format_rows.h"
#include "core/layout/formats/losses.h"
#include "core/layout/formats/sensor_yaml.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldBySensorYaml{false, false, true, true, false, true, false, true};

/// Returns a number that every parser of YAML takes for a number with decimals, in the shortest form that reads back.
std::string yaml_number(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  if (text.find('.') == std::string::npos) text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

std::string yaml_vector(const dvec3& v) {
  return fmt::format("[{}, {}, {}]", yaml_number(v.x), yaml_number(v.y), yaml_number(v.z));
}

std::string yaml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

void append_taxels(std::string& text, const ImportedLayout& one, std::vector<std::string>& notes) {
  const std::vector<Taxel>& taxels = one.layout.taxels;
  const auto [least, most] = std::minmax_element(taxels.begin(), taxels.end(),
                                                 [](const Taxel& a, const Taxel& b) { return a.radius < b.radius; });
  if (least->radius != most->radius)
    notes.push_back(
        fmt::format("a sensor has one radius for all taxels: the largest is written, {} m (the smallest is {} m)",
                    most->radius, least->radius));
  text += fmt::format("        include_margin: {}\n        taxels:\n", yaml_number(most->radius));
  for (const Taxel& taxel : taxels) text += "          - " + yaml_vector(taxel.center) + "\n";
  if (!one.has_normals) return;
  text += "        normals:\n";
  for (const Taxel& taxel : taxels) text += "          - " + yaml_vector(taxel.normal) + "\n";
}

void append_sensor(std::string& text, const ImportedLayout& one, std::vector<std::string>& notes) {
  const char* const type = one.cell > 0 ? "FlatTactileSensor" : one.has_normals ? "CurvedSensor" : "TaxelSensor";
  text += fmt::format("      - type: mujoco_contact_surface_sensors/{}\n        sensorName: {}\n        geomName: {}\n",
                      type, yaml_text(one.layout.name), yaml_text(one.geom));
  if (one.cell > 0) {
    text += fmt::format("        resolution: {}\n", yaml_number(one.cell));
    return;
  }
  const double density = one.layout.sampling.density;
  if (one.has_density && density >= 1) text += fmt::format("        sample_resolution: {}\n", yaml_number(density));
  append_taxels(text, one, notes);
}

WrittenLayouts write_sensor_yaml(const std::vector<ImportedLayout>& layouts) {
  WrittenLayouts written;
  written.bytes =
      "MujocoPlugins:\n  - type: mujoco_contact_surfaces/MujocoContactSurfacesPlugin\n    SurfacePlugins:\n";
  written.notes = losses_in(layouts, kHeldBySensorYaml, "a sensor description");
  bool has_geoms = true;
  for (const ImportedLayout& one : layouts) {
    if (one.cell <= 0) check_taxels_to_write({one});
    if (one.has_normals && one.cell <= 0) require_normals({one}, "a CurvedSensor");
    append_sensor(written.bytes, one, written.notes);
    has_geoms = has_geoms && !one.geom.empty();
  }
  written.notes.emplace_back(has_geoms ? "topicName and updateRate are to be added to the file"
                                       : "geomName, topicName and updateRate are to be filled in");
  return written;
}

}  // namespace

LayoutFormat sensor_yaml_format() {
  LayoutFormat format{"yaml", "Sensor description of mujoco_contact_surfaces", {".yaml", ".yml"}};
  format.holds = kHeldBySensorYaml;
  format.reads_several = format.writes_several = true;
  format.parse = parse_sensors_yaml;
  format.write = write_sensor_yaml;
  return format;
}

}  // namespace taxel
