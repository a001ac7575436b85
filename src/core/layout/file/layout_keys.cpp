#include "core/layout/file/layout_keys.h"

#include <string>
#include <vector>

#include "core/layout/layout_fields.h"

namespace taxel {
namespace {

struct ObjectKeys {
  std::string_view place;  ///< JSON pointer with * for an index
  std::vector<std::string_view> keys;
};

template <class S>
std::vector<std::string_view> keys_of() {
  std::vector<std::string_view> keys;
  for_each_field<S>([&](const LayoutField& field, auto) { keys.emplace_back(field.spec.key); });
  return keys;
}

const std::vector<ObjectKeys>& object_keys() {
  static const std::vector<ObjectKeys> rows = {
      {"",
       {"format", "version", "name", "mesh", "frame", "sampling", "receptive_field", "readout", "material", "taxels",
        "calibration"}},
      {"/mesh", keys_of<MeshRef>()},
      {"/mesh/repair", keys_of<RepairRecipe>()},
      {"/frame", keys_of<SensorFrame>()},
      {"/sampling", keys_of<Sampling>()},
      {"/receptive_field", keys_of<ReceptiveFieldRule>()},
      {"/readout", keys_of<Readout>()},
      {"/material", keys_of<Material>()},
      {"/taxels/*", {"id", "name", "center", "normal", "radius", "subtaxels", "density"}},
      {"/taxels/*/subtaxels/*", {"center", "normal", "radius"}},
      {"/calibration", keys_of<Calibration>()},
      {"/calibration/response", keys_of<Response>()},
      {"/calibration/relaxation/*", keys_of<RelaxationArm>()},
      {"/calibration/hysteresis", keys_of<Hysteresis>()},
      {"/calibration/hysteresis/plays/*", keys_of<Play>()},
      {"/calibration/low_pass", keys_of<LowPass>()},
      {"/calibration/crosstalk", keys_of<Crosstalk>()},
      {"/calibration/quantisation", keys_of<Quantisation>()},
      {"/calibration/dead", keys_of<DeadTaxels>()},
      {"/calibration/taxels/*", keys_of<TaxelCalibration>()},
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
