// Bodies whose middle is behind the pad of a soft body: they fell through its skin, or began there.
#pragma once

#include "core/hydro/hydro_body.h"

namespace taxel {

/// Returns a point in the material of a body, frame of the body: the middle of its bounds or, if the body is hollow
/// there (a ring, a cup), the vertex that is nearest to it. The origin for a half-space, which is behind no skin.
dvec3 inner_point(const HydroBody& body);

/// How far a point is behind a skin.
struct BehindSkin {
  double depth = 0;      ///< distance to the skin, negative outside [m]
  double thickness = 0;  ///< thickness of the pad [m]
  [[nodiscard]] bool beyond_the_pad() const { return depth > thickness; }
};

/// Returns the depth of a point in the frame of a body: 0 and 0 unless the body has a pad or is a soft half-space.
/// O(log n).
BehindSkin behind_skin(const HydroBody& body, const dvec3& x);

}  // namespace taxel
