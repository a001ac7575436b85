// Contact without holes: where a rigid surface reaches beyond a pad's tets, it is cut into pieces on which the depth
// below the skin is nearly linear, and p = (E/H) D there.
#pragma once

#include "core/hydro/kernel/depth_field.h"
#include "core/hydro/kernel/depth_workspace.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"

namespace taxel {

/// Adds the pieces of the triangles in `workspace`, which have pose X_SR in the frame S of the field. Their polygons of
/// the tets stay: pieces fill what these leave. Each gets tet -1 and the triangle's face.
void add_depth_pieces(const DepthField& depth, const TriangleTree& rigid, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace);

/// Adds those of the plane z = 0 of a frame R with pose X_SR, all of whose polygons are in the writer's surface.
void add_depth_pieces(const DepthField& depth, const RigidTransform& X_SR, const DepthPieceSize& size,
                      SurfaceWriter& writer, DepthWorkspace& workspace);

}  // namespace taxel
