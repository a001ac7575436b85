// From what a file says to a mesh that TriMesh takes.
#pragma once

#include <string>
#include <vector>

#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Scales, welds vertices at exactly the same place, drops triangles without area (two corners at one place, or an area
/// lost in the rounding of its edges) and repeated ones (same corners, same direction), drops unused vertices. Keeps
/// the order of what stays. Says in `notes` what it did. A negative product of the scale flips the winding.
/// `face_of` (optional) gets, for each face, the number of its triangle in `soup`.
/// Throws Error without a file name: scale not finite or zero, index out of range, no triangles.
TriMesh weld(const PolygonSoup& soup, const dvec3& scale, std::vector<std::string>& notes,
             std::vector<int>* face_of = nullptr);

}  // namespace taxel
