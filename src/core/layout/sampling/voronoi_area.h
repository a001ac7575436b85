// Voronoi area of each sample on a surface.
#pragma once

#include <vector>

#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Fills SurfaceSample::area with the area of the sample's Voronoi cell restricted to the surface: the part of the mesh
/// that is nearer to it than to any other sample of the same wall (of any wall, where its own has none nearby). Faces
/// are cut exactly along the bisecting planes, so the areas sum to that of the mesh. `samples` is not empty.
void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples);

}  // namespace taxel
