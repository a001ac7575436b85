// Voronoi area of each sample on a surface.
#pragma once

#include <vector>

#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Fills SurfaceSample::area with the area of the sample's Voronoi cell on the surface: the part of the mesh that is
/// nearer to this sample than to any other sample of the same wall (or of any wall, if the wall has no sample nearby).
/// Faces are clipped exactly along the bisecting planes, so the sum of the areas is the area of the mesh. `samples`
/// must not be empty.
void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples);

}  // namespace taxel
