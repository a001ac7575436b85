// Tents: vertices close above a skin face, by which the stiffness there is exactly E/H.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_layers.h"

namespace taxel {

/// The tets of a pad, their vertices and the pressures there, while the pad is being made. Vertices of the skin come
/// first, with their numbers in the mesh.
struct PadTets {
  std::vector<dvec3> vertices;
  std::vector<ivec4> tets;
  std::vector<double> pressure;  ///< at each vertex [Pa]
};

/// Splits the tet (a, b, c, x) of a skin face (a, b, c) into four where its gradient differs from E/H by more than 2 %,
/// by a vertex m between the incentre of the face and x, low enough to be no nearer to any other part of the skin, with
/// p(m) = (E/H) times the height of m above the face. All other tets keep their vertices. Returns the number of split
/// tets. Cost: a few closest-point queries per split tet.
int split_by_tents(const MeshIndex& index, PadTets& pad, double modulus, double thickness);

/// Gives faces without a tet (`bare`, one flag per face) a tet of their own where one fits between the tets around, of
/// height r tan(a/2): r is the radius of the face's incircle, a the least angle at its edges to the skin and the tets
/// there. Clears their flags, and returns how many there are. Cost: only if there are such faces, a tree of all tets.
int add_own_tents(const MeshIndex& index, PadTets& pad, std::vector<char>& bare, double modulus, double thickness);

}  // namespace taxel
