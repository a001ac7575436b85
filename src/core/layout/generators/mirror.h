// The other half of a symmetric layout.
#pragma once

#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Through `point` [m], at right angles to `normal` (any length).
struct MirrorPlane {
  dvec3 point{0};
  dvec3 normal{1, 0, 0};
  bool operator==(const MirrorPlane&) const = default;
};

/// Each taxel at its mirror image: centres, normals, subtaxels; ids, names and order kept. Its own inverse.
/// The images lie on the skin as well as the skin is symmetric. Throws Error naming the parameter.
std::vector<Taxel> mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane);

/// What an image is called: "left" and "right" change places, other names get " mirrored", none stays none.
std::string mirrored_name(const std::string& name);

/// The taxels, and after them the images of those that have none yet: taxels that lie on the plane, or whose image
/// another taxel already is (to within `tolerance`, metres), add nothing, so doing it twice changes nothing. New ids
/// follow the largest one, in the order of the originals, names are those of mirrored_name. Throws Error naming the
/// parameter.
std::vector<Taxel> with_mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane,
                                      double tolerance = 1e-6);

}  // namespace taxel
