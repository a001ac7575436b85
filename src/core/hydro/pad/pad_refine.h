// Refinement of a pad's skin: on coarse faces next to sharp edges the pad of a whole face cannot be even.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_shape.h"
#include "core/hydro/pad/pad_tents.h"

namespace taxel {

/// A mesh of the same surface with more faces.
struct RefinedSkin {
  TriMeshPtr mesh;           ///< vertices of the given mesh first, with their numbers
  std::vector<int> face_of;  ///< for each face the given face that it is part of
};

/// Flags the faces that are worth a refinement: an edge longer than `longest` [m], an offset vector at an angle of more
/// than 26 degrees (cosine < 0.9) to the face's normal, and a pressure that differs from E depth/H by more than 3 %, or
/// none where the body has room for it, at a tenth of H below one of four points: the centroid, and next to the middle
/// of each edge. So the exact mitres of a box stay. Cost: four closest-point queries per such face.
std::vector<char> uneven_faces(const MeshIndex& index, const PadShape& shape, const PadTets& pad, double modulus,
                               double thickness, double longest);

/// Bisects the longest edge of wanted faces, and of those that come from them, until none is longer than `longest` [m]
/// or the mesh has `most_faces`. Rivara (1997): if the face across has a longer edge, that edge is bisected first, so
/// that no angle falls below half of the least one before. Longest edges come first; of equal ones, that of the lowest
/// vertex numbers. The new mesh is the same surface, but for rounding.
RefinedSkin refine_skin(const TriMesh& mesh, std::vector<char> wanted, double longest, int most_faces);

}  // namespace taxel
