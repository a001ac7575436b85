// A layout from a file of any format, with the values that the file does not have.
#pragma once

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
  bool has_radii = true;    ///< false if the file gives no radius of some taxels: they have the default of Taxel
  bool has_normals = true;  ///< false if the skin gives the normals of the taxels
  /// Edge length of the square cells that cover the top of the skin if the file lists no taxels, otherwise 0 [m].
  double cell = 0;
  bool has_density = true;   ///< true if the file gives layout.sampling.density
  bool has_material = true;  ///< true if the file gives layout.material
  bool has_frame = true;     ///< true if the file gives layout.frame
};

}  // namespace taxel
