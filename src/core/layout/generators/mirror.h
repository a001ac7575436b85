// Mirror images of taxels, for the other half of a symmetric layout.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A plane through `point` [m], at right angles to `normal` (any length).
struct MirrorPlane {
  dvec3 point{0};
  dvec3 normal{1, 0, 0};
  bool operator==(const MirrorPlane&) const = default;
};

/// Returns the mirror images of centres, normals and subtaxels, with unchanged ids, names and order. The function is
/// its own inverse. Images are off the skin as far as the skin is asymmetric. Throws Error that names the parameter.
std::vector<Taxel> mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane);

/// Returns the layout of the mirrored mesh, such as that of the other hand: the mesh has a scale of the opposite sign
/// along `axis` (0 to 2), and taxels and frame are mirrored with it, so that both hands have the same readings in
/// mirrored contacts. Ids and order stay. The function is its own inverse, but for the layout's name.
Layout mirrored_layout(Layout layout, int axis);

/// Returns the name of an image: "left" and "right" change places, other names get " mirrored", an empty name is empty.
std::string mirrored_name(const std::string& name);

/// Returns the taxels, and after them the missing images. A taxel on the plane, or with another taxel within
/// `tolerance` [m] of its image, adds no image, so a second call changes nothing. New ids follow the largest id, in the
/// order of the originals; names are those of mirrored_name. Throws Error that names the parameter.
std::vector<Taxel> with_mirror_images(const std::vector<Taxel>& taxels, const MirrorPlane& plane,
                                      double tolerance = 1e-6);

/// Returns for each of these taxels (indices of the layout) the place of its twin in `taxels`, or -1. Twins are mirror
/// images of each other, up to half of a radius. The mirror plane contains the distal direction and that of the pad; it
/// is through the middle of all centres or the origin, whichever gives more twins.
std::vector<int> mirror_twins(const Layout& layout, std::span<const std::size_t> taxels);

}  // namespace taxel
