// Voronoi cells of the samples on a surface.
#pragma once

#include <span>
#include <vector>

#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Fills SurfaceSample::area with the area of the sample's Voronoi cell on the surface: the part of the mesh that is
/// nearer to this sample than to any other sample of the same wall (or of any wall, if the wall has no sample nearby).
/// Faces are clipped exactly along the bisecting planes, so the sum of the areas is the area of the mesh. `samples`
/// must not be empty.
void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples);

/// Returns for each point the index of the sample whose Voronoi cell it is in: the nearest sample of the same wall (of
/// any wall, if no sample is on the same wall within 4 spacings). `spacing` is about that of the samples [m]. `samples`
/// must not be empty.
std::vector<int> cells_of(std::span<const SurfaceSample> points, const std::vector<SurfaceSample>& samples,
                          double spacing);

/// Returns the parts of `mesh` in the Voronoi cells of the samples for which `is_wanted` is true, as triangles that do
/// not share vertices. `spacing` is about that of the samples [m].
TriMesh surface_of_cells(const TriMesh& mesh, const std::vector<SurfaceSample>& samples,
                         const std::vector<bool>& is_wanted, double spacing);

}  // namespace taxel
