// Adds contact beyond a pad's tets, so that contact surfaces have no holes. The part of a rigid surface that reaches
// beyond the tets is divided into pieces on which the depth D below the skin is nearly linear, with p = (E/H) D.
#pragma once

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/depth_workspace.h"
#include "core/hydro/kernel/index/facet_tree.h"
#include "core/hydro/kernel/index/field_index.h"
#include "core/hydro/kernel/surface_writer.h"

namespace taxel {

/// Adds the pieces of the facets in `workspace`, which have pose X_SR in the frame S of the field and of its tets. The
/// polygons of the tets remain, and the pieces fill the rest of the facets. Each piece gets tet -1 and the facet's
/// face.
void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const FacetTree& rigid,
                      const RigidTransform& X_SR, const DepthPieceSize& size, SurfaceWriter& writer,
                      DepthWorkspace& workspace);

/// Adds the pieces of the plane z = 0 of a frame R with pose X_SR. All polygons of the plane must be in the writer's
/// surface.
void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace);

}  // namespace taxel
