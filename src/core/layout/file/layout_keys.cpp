#include "core/layout/file/layout_keys.h"

#include <string>
#include <vector>

namespace taxel {
namespace {

struct ObjectKeys {
  std::string_view place;  ///< JSON pointer with * for an index
  std::vector<std::string_view> keys;
};

const std::vector<ObjectKeys>& object_keys() {
  static const std::vector<ObjectKeys> rows = {
      {"",
       {"format", "version", "name", "mesh", "frame", "sampling", "receptive_field", "readout", "material", "taxels",
        "calibration"}},
      {"/mesh", {"file", "scale", "sha256", "repair"}},
      {"/mesh/repair", {"level", "join", "fill", "edge", "tolerance", "refine"}},
      {"/frame", {"distal", "pad"}},
      {"/sampling", {"density", "seed", "weights", "shells", "region"}},
      {"/receptive_field", {"metric", "max_angle_deg", "angle_falloff_deg", "normals"}},
      {"/readout", {"aggregate", "method", "misses", "ray", "max_depth", "shear"}},
      {"/material",
       {"field", "modulus", "thickness", "dissipation", "friction", "faces", "tangential_stiffness", "bristles"}},
      {"/taxels/*", {"id", "name", "center", "normal", "radius", "subtaxels", "density"}},
      {"/taxels/*/subtaxels/*", {"center", "normal", "radius"}},
      {"/calibration",
       {"seed", "unit", "hysteresis", "crosstalk", "quantisation", "dead", "tare", "tare_deviation", "gain", "curve",
        "gain_deviation", "noise", "range", "rate", "taxels"}},
      {"/calibration/hysteresis", {"width", "fraction"}},
      {"/calibration/crosstalk", {"fraction", "reach"}},
      {"/calibration/quantisation", {"step", "bits"}},
      {"/calibration/dead", {"fraction", "value"}},
      {"/calibration/taxels/*", {"id", "tare", "gain", "curve", "dead"}},
  };
  return rows;
}

/// Returns the pointer with * for each part that is a number.
std::string without_indices(std::string_view pointer) {
  std::string place;
  while (!pointer.empty()) {
    const std::size_t end = pointer.find('/', 1);
    const std::string_view part = pointer.substr(0, end);
    const bool is_index = part.size() > 1 && part.find_first_not_of("0123456789", 1) == std::string_view::npos;
    place += is_index ? "/*" : part;
    pointer = end == std::string_view::npos ? std::string_view{} : pointer.substr(end);
  }
  return place;
}

}  // namespace

std::span<const std::string_view> known_layout_keys(std::string_view pointer) {
  const std::string place = without_indices(pointer);
  for (const ObjectKeys& row : object_keys())
    if (row.place == place) return row.keys;
  return {};
}

}  // namespace taxel
