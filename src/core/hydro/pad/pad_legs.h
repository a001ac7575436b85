// Offset vectors ("legs") from the skin into a pad, and the tets that fill the gaps between them.
#pragma once

#include <map>
#include <vector>

#include "core/hydro/pad/pad_directions.h"

namespace taxel {

/// The gap below a skin edge whose two faces go different ways: legs of u and of v, from the face that holds u -> v to
/// the one that holds v -> u, at least one at each end.
struct PadWedge {
  int u, v;
  std::vector<int> at_u, at_v;
};

/// The gap below a skin vertex where three or more ways part: legs around it, counter-clockwise seen from outside, and
/// one in the middle.
struct PadCone {
  int v, center;
  std::vector<int> rim;
};

/// A leg goes from a skin vertex to an inner one. Most vertices have one leg, of their own number. Where faces around a
/// vertex part at sharp concave edges (split normals), each group of faces between two of them has its own leg, and
/// further legs fan out between: below such an edge the points of one depth lie on a round, not on two planes. A crease
/// that ends at a vertex parts its faces too, where the faces opposite to it are flat enough to be parted.
struct PadLegs {
  std::vector<int> skin;             ///< per leg: its skin vertex
  std::vector<PadDirection> inward;  ///< per leg
  std::vector<ivec3> of_face;        ///< per face: the legs of its corners
  std::vector<PadWedge> wedges;
  std::vector<PadCone> cones;
};

/// The creases of a mesh: sharp concave edges.
struct PadCreases {
  std::map<int, std::vector<int>> ends;    ///< vertex -> other ends of its creases
  std::map<int, std::vector<int>> around;  ///< the same vertices -> faces around them
};

/// Leaves out vertices at which a crease is shorter than `shortest` [m]: there is hardly a gap. `directions`: of the
/// whole vertices (pad_directions).
PadCreases find_pad_creases(const TriMesh& mesh, const std::vector<PadDirection>& directions, double shortest);

/// `whole`: vertices that must not be split.
PadLegs make_pad_legs(const TriMesh& mesh, const std::vector<PadDirection>& directions, const PadCreases& creases,
                      const std::vector<char>& whole);

/// Tets of positive volume in a gap between the skin and the vertices at which the legs end, one per leg; where one
/// ends on the skin those that this flattens are left out.
std::vector<ivec4> gap_tets(const PadWedge& wedge, const std::vector<int>& ends);
std::vector<ivec4> gap_tets(const PadCone& cone, const std::vector<int>& ends);

/// The triangles that close a gap further inside, in numbers of legs, counter-clockwise seen from outside.
std::vector<ivec3> gap_floor(const PadWedge& wedge);
std::vector<ivec3> gap_floor(const PadCone& cone);

}  // namespace taxel
