// Tents: additional vertices close to a skin face, with which the stiffness at the face is exactly E/H.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_layers.h"

namespace taxel {

/// The tets of a pad that is being built, with vertices and pressures. Vertices of the skin come first, with their
/// indices in the mesh.
struct PadTets {
  std::vector<dvec3> vertices;
  std::vector<ivec4> tets;
  std::vector<double> pressure;  ///< pressure at each vertex [Pa]
};

/// Splits the tet (a, b, c, x) of a skin face (a, b, c) into four tets if its gradient differs from E/H by more than 2
/// %. The new vertex m is between the incentre of the face and x, so close to the face that no other part of the skin
/// is nearer, and p(m) is (E/H) times the height of m above the face. All other tets keep their vertices. Returns the
/// number of split tets. Cost: a few closest-point queries per split tet.
int split_by_tents(const MeshIndex& index, PadTets& pad, double modulus, double thickness);

/// Adds a tet to each face without one (`bare`, one flag per face), if it fits between the tets around the face. The
/// height of the tet is r tan(a/2), where r is the radius of the face's incircle and a the smallest angle at its edges
/// to the skin and to other tets. Clears the flags of these faces, and returns their number. Cost: a tree of all tets,
/// if there are such faces.
int add_own_tents(const MeshIndex& index, PadTets& pad, std::vector<char>& bare, double modulus, double thickness);

}  // namespace taxel
