// A layout from a file of any format, with the values that the file does not have.
#pragma once

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A layout as read. The values that the file does not have come from a skin (imported_skin.h).
struct ImportedLayout {
  Layout layout;
  std::vector<std::string> notes;             ///< sentences on values that are not from the file
  std::string geom = {};                      ///< geom or link that the file puts the sensor on, or empty
  std::string geom_place = {};                ///< place of that name for messages, such as "line 8, key geomName"
  std::vector<std::string> other_geoms = {};  ///< geoms of the file's other sensors
  /// Indices into layout.taxels, ascending, of the taxels whose radius the file does not give: it is Taxel's default.
  std::vector<std::size_t> missing_radii = {};
  bool has_normals = true;  ///< false if the skin gives the normals of the taxels whose normal is zero
  bool has_units = false;   ///< true if the file or its format names the unit of lengths
  /// Edge length of the square cells that cover the top of the skin if the file lists no taxels, otherwise 0 [m].
  double cell = 0;
  bool has_density = true;   ///< true if the file gives layout.sampling.density
  bool has_material = true;  ///< true if the file gives layout.material
  bool has_frame = true;     ///< true if the file gives layout.frame

  [[nodiscard]] bool has_radii() const { return missing_radii.empty(); }
  /// Sets that the file gives the normal of no taxel. Call it when all taxels are in the layout.
  void set_all_normals_missing() {
    has_normals = false;
    for (Taxel& taxel : layout.taxels) taxel.normal = dvec3(0);
  }
  /// Sets that the file gives the radius of no taxel. Call it when all taxels are in the layout.
  void set_all_radii_missing() {
    missing_radii.resize(layout.taxels.size());
    std::iota(missing_radii.begin(), missing_radii.end(), std::size_t{0});
  }
};

}  // namespace taxel
