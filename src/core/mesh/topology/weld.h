// Converts the polygons of a file to a valid TriMesh.
#pragma once

#include <string>
#include <vector>

#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Scales, welds vertices at exactly the same place, drops triangles without area (two corners at one place, or an area
/// lost in the rounding of its edges) and repeated ones (same corners, same direction), drops unused vertices. Keeps
/// the order of the rest. Describes the changes in `notes`. A negative product of the scale flips the winding.
/// `face_of` (optional) gets the number in `soup` of each face's triangle. Throws Error without a file name if the
/// scale is not finite or zero, an index is out of range, or there are no triangles.
TriMesh weld(PolygonSoup soup, const dvec3& scale, std::vector<std::string>& notes,
             std::vector<int>* face_of = nullptr);

}  // namespace taxel
