// Refinement of a pad's skin. On coarse faces next to sharp edges, the stiffness of the pad below a whole face would
// not be uniform.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_shape.h"
#include "core/hydro/pad/pad_tents.h"

namespace taxel {

/// A mesh of the same surface with more faces.
struct RefinedSkin {
  TriMeshPtr mesh;           ///< vertices of the given mesh first, with their indices
  std::vector<int> face_of;  ///< for each face, the given face of which it is a part
};

/// Flags the faces that need refinement. Such a face has an edge longer than `longest` [m], and an offset vector at
/// more than 26 degrees (cosine < 0.9) from the face's normal. At a tenth of H below one of four points (the centroid,
/// and points next to the middles of the edges), its pressure differs from E depth/H by more than 3 %, or there is no
/// tet although the body has room for one. So the exact mitres of a box are not refined. Cost: four closest-point
/// queries per such face.
std::vector<char> uneven_faces(const MeshIndex& index, const PadShape& shape, const PadTets& pad, double modulus,
                               double thickness, double longest);

/// Bisects the longest edge of wanted faces, and of those that come from them, until no edge is longer than `longest`
/// [m] or the mesh has `most_faces`. If the face across an edge has a longer edge, that edge is bisected first, so no
/// angle becomes less than half of the smallest former angle (Rivara 1997). The longest edges are bisected first; of
/// equally long edges, the one with the lowest vertex indices. The surface does not change, except for rounding.
RefinedSkin refine_skin(const TriMesh& mesh, std::vector<char> wanted, double longest, int most_faces);

}  // namespace taxel
