// Computes the places of the taxels on a flat map of the sensor.
#pragma once

#include <vector>

#include "core/layout/layout.h"

namespace taxel {

struct FlatMap {
  std::vector<dvec2> places;  ///< places of the taxels [m]: right, up
  /// Smallest distance of two places [m], at most twice the typical distance on the sensor; 0 if there is one taxel, or
  /// all are at one place.
  double apart = 0;
  bool unrolled = false;  ///< unrolled around the axis; if false, seen along the mean normal
};

/// Returns the map, in which the layout's `distal` is up. If all normals are less than 60 degrees from their mean, the
/// taxels are seen along the mean normal. Otherwise they are unrolled about the axis through `inside` along `distal`:
/// the coordinate to the right is the arc length around the axis at the taxel's distance from the axis, so that lengths
/// across are true and a tip becomes a point; `pad` is in the middle and the seam at the back. Taxels that are closer
/// on the map than taxels typically are on the sensor are moved apart. If unrolled, turning a taxel's normal does not
/// move it. Deterministic.
FlatMap flat_map(const Layout& layout, const dvec3& inside);

}  // namespace taxel
