// Offset vectors ("legs") from the skin into a pad, and the tets that fill the gaps between them.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace taxel {

struct PadDirection {
  dvec3 direction{0};       ///< inward unit vector
  double least_cosine = 0;  ///< least cosine to the inward normals of the used faces
};

/// Returns the direction at each vertex: minus the angle-weighted normal, if its angles to the inward normals of all
/// faces around the vertex are below 60 degrees; otherwise the direction whose largest angle is smallest. If a face is
/// then still almost edge-on, as on folded or torn tessellations, the smallest faces are left out as long as they are a
/// small fraction of the area around the vertex.
std::vector<PadDirection> pad_directions(const TriMesh& mesh);

/// Returns the direction at one vertex for some of the faces around it.
PadDirection pad_direction(const TriMesh& mesh, int vertex, std::span<const int> faces);

/// The gap below a skin edge u, v whose two faces have different offset directions. It has legs of u and of v, at least
/// one at each end, ordered from the face with the half-edge u -> v to the face with v -> u.
struct PadWedge {
  int u, v;
  std::vector<int> at_u, at_v;
};

/// The gap below a skin vertex with three or more offset directions: legs around the vertex, counter-clockwise seen
/// from outside, and one leg in the middle.
struct PadCone {
  int v, center;
  std::vector<int> rim;
};

/// The offset vectors ("legs") of a pad. A leg leads from a skin vertex to an inner vertex. Most vertices have one leg,
/// with the index of the vertex. If sharp concave edges (split normals) meet at a vertex, each group of faces between
/// two such edges has its own leg, and more legs fan out in between, because the points of one depth below such an edge
/// are on a round surface, not on two planes. A crease that ends at a vertex also divides the faces of the vertex, if
/// the faces opposite to the crease are flat enough to be divided.
struct PadLegs {
  std::vector<int> skin;             ///< skin vertex of each leg
  std::vector<PadDirection> inward;  ///< direction of each leg
  std::vector<ivec3> of_face;        ///< legs of the corners of each face
  std::vector<PadWedge> wedges;
  std::vector<PadCone> cones;
};

/// The creases of a mesh: sharp concave edges.
struct PadCreases {
  std::map<int, std::vector<int>> ends;    ///< other ends of the creases of a vertex
  std::map<int, std::vector<int>> around;  ///< faces around a vertex with creases
};

/// Returns the creases, without vertices at which a crease is shorter than `shortest` [m], because there is almost no
/// gap. `directions` are the directions of undivided vertices (pad_directions).
PadCreases find_pad_creases(const TriMesh& mesh, const std::vector<PadDirection>& directions, double shortest);

/// Builds the legs. `whole` has the vertices that must not be divided.
PadLegs make_pad_legs(const TriMesh& mesh, const std::vector<PadDirection>& directions, const PadCreases& creases,
                      const std::vector<char>& whole);

/// Returns the tets in a gap between the skin and the end vertices of the legs, `ends`. Tets that are flat because a
/// leg ends on the skin are left out, so all volumes are positive.
std::vector<ivec4> gap_tets(const PadWedge& wedge, const std::vector<int>& ends);
std::vector<ivec4> gap_tets(const PadCone& cone, const std::vector<int>& ends);

/// Returns the triangles that close a gap at its inner end, as indices of legs, counter-clockwise seen from outside.
std::vector<ivec3> gap_floor(const PadWedge& wedge);
std::vector<ivec3> gap_floor(const PadCone& cone);

}  // namespace taxel
