// Places of the taxels on a flat map of the sensor.
#pragma once

#include <vector>

#include "core/layout/layout.h"

namespace taxel {

struct FlatMap {
  std::vector<dvec2> places;  ///< places of the taxels [m]: right, up
  /// The least distance of two of them, at most twice the typical one on the sensor [m]; 0 for one taxel, and where
  /// all are in one place.
  double apart = 0;
  bool unrolled = false;  ///< around the axis; else seen along the mean normal
};

/// Up is the layout's `distal`. Taxels that all look much the same way (less than 60 degrees from their mean normal)
/// are seen along it; others are unrolled about the axis through `inside` along `distal`: right is the way around the
/// axis at the taxel's own distance from it, so that lengths across are true and a tip comes to a point, with `pad` in
/// the middle and the seam at the back. Where the flat picture brings two closer together than taxels typically are on
/// the sensor, they are moved apart. Turned taxels do not move; the same for the same layout.
FlatMap flat_map(const Layout& layout, const dvec3& inside);

}  // namespace taxel
