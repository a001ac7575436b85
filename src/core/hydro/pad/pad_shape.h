// The shape of a pad: offset vectors from the skin into the pad, the inner vertices at their ends, and the tets between
// them and the skin.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/hydro/fields/tet_geometry.h"
#include "core/mesh/query/closest_point.h"
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

/// The gap below a skin edge u, v whose two faces have different offset directions. It has offset vectors of u and of
/// v, at least one at each end, ordered from the face with the half-edge u -> v to the face with v -> u.
struct PadWedge {
  int u, v;
  std::vector<int> at_u, at_v;
};

/// The gap below a skin vertex with three or more offset directions: offset vectors around the vertex,
/// counter-clockwise seen from outside, and one offset vector in the middle.
struct PadCone {
  int v, center;
  std::vector<int> rim;
};

/// The offset vectors of a pad. An offset vector leads from a skin vertex to an inner vertex. Most vertices have one
/// offset vector, with the index of the vertex. If sharp concave edges (split normals) meet at a vertex, each group of
/// faces between two such edges has its own offset vector, and more offset vectors fan out in between, because the
/// points of one depth below such an edge are on a round surface, not on two planes. A crease that ends at a vertex
/// also divides the faces of the vertex, if the faces opposite to the crease are flat enough to be divided.
struct PadOffsets {
  std::vector<int> skin;             ///< skin vertex of each offset vector
  std::vector<PadDirection> inward;  ///< direction of each offset vector
  std::vector<ivec3> of_face;        ///< offset vectors of the corners of each face
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

/// Builds the offset vectors. `whole` has the vertices that must not be divided.
PadOffsets make_pad_offsets(const TriMesh& mesh, const std::vector<PadDirection>& directions, const PadCreases& creases,
                            const std::vector<char>& whole);

/// Returns the tets in a gap between the skin and the end vertices of the offset vectors, `ends`. Tets that are flat
/// because an offset vector ends on the skin are left out, so all volumes are positive.
std::vector<ivec4> gap_tets(const PadWedge& wedge, const std::vector<int>& ends);
std::vector<ivec4> gap_tets(const PadCone& cone, const std::vector<int>& ends);

/// Returns the triangles that close a gap at its inner end, as indices of offset vectors, counter-clockwise seen from
/// outside.
std::vector<ivec3> gap_floor(const PadWedge& wedge);
std::vector<ivec3> gap_floor(const PadCone& cone);

/// Returns min(depth, most) of a point inside the mesh. Fast, since only skin within the distance `most` is tested.
double depth_inside(const MeshIndex& index, const dvec3& x, double most);

/// Returns true if, within three percent, `distance` [m] is the distance of a point inside the mesh to the nearest
/// skin, so that no other part of the skin is nearer.
bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance);

/// The inner vertices of a pad. Each offset vector (pad_shape.h) ends at an inner vertex. Its length is the pad's
/// thickness, or less if the body is too thin. Vertices of the skin have their indices in the mesh; the inner vertex of
/// offset vector i has the index i + vertex_count().
class PadShape {
 public:
  /// `coarse`, if given, is a shape of the same surface and thickness whose vertices come first in this mesh; offset
  /// vectors with the direction of a coarse one have its length. Cost: some closest-point queries per vertex.
  PadShape(const MeshIndex& index, double thickness, const PadShape* coarse = nullptr);

  [[nodiscard]] int offset_count() const { return static_cast<int>(offsets_.skin.size()); }
  [[nodiscard]] const PadOffsets& offsets() const { return offsets_; }
  [[nodiscard]] int offset(int face, int corner) const { return offsets_.of_face[at(face)][corner]; }
  /// Returns the point at the distance h along an offset vector.
  [[nodiscard]] dvec3 moved(int offset, double h) const {
    return skin(offset) + h * offsets_.inward[at(offset)].direction;
  }
  [[nodiscard]] dvec3 inner_position(int offset) const { return moved(offset, length_[at(offset)]); }
  /// Returns the index of the inner vertex, or of the skin vertex if the offset vector is collapsed.
  [[nodiscard]] int inner(int offset) const {
    return collapsed_[at(offset)] ? offsets_.skin[at(offset)] : offset + mesh_.vertex_count();
  }
  [[nodiscard]] bool collapsed(int offset) const { return collapsed_[at(offset)] != 0; }
  [[nodiscard]] double length(int offset) const { return length_[at(offset)]; }
  [[nodiscard]] const PadDirection& direction(int offset) const { return offsets_.inward[at(offset)]; }
  /// Returns the distance of the inner vertex to the skin, not negative [m].
  [[nodiscard]] double depth(int offset) const { return depth_[at(offset)]; }
  /// Returns true if an offset vector is shorter than the thickness requires.
  [[nodiscard]] bool limited(int offset) const { return length_[at(offset)] < 0.999 * own_[at(offset)].full; }
  /// Returns the length divided by the length that the thickness requires, 0 to 1.
  [[nodiscard]] double part_left(int offset) const { return length_[at(offset)] / own_[at(offset)].full; }
  /// Returns the tets below a face, as indices of skin and inner vertices. There are three; fewer if corners are
  /// collapsed, and none if the face has no prism. All volumes are positive.
  [[nodiscard]] PrismTets tets(int face) const;
  /// Returns inner() of every offset vector.
  [[nodiscard]] std::vector<int> ends() const;

 private:
  friend class PadFit;
  /// Cosine below which a face is almost edge-on to the direction of one of its corners, so that its prism would be
  /// inverted for any offset.
  static constexpr double kEdgeOn = 0.1;
  /// Largest length of an offset vector, without the limits by other offset vectors.
  struct OwnLength {
    bool is_found = false;
    char collapsed = 0;
    double length = 0, full = 0;  ///< `full` is the length without limits [m]
    double depth = 0;             ///< depth at the end [m]; negative if unknown
  };

  explicit PadShape(const TriMesh& mesh) : mesh_(mesh) {}
  [[nodiscard]] const dvec3& skin(int offset) const { return mesh_.vertices()[at(offsets_.skin[at(offset)])]; }
  [[nodiscard]] dvec3 position(int vertex) const;
  [[nodiscard]] bool can_be_filled(int face) const;
  [[nodiscard]] PrismTets prism(int face) const;
  [[nodiscard]] bool well_shaped(int face, double part) const;

  const TriMesh& mesh_;
  PadOffsets offsets_;
  std::vector<OwnLength> own_;
  std::vector<double> length_;   ///< length of each offset vector [m]
  std::vector<double> depth_;    ///< depth of each inner vertex; negative if the length has changed since
  std::vector<char> collapsed_;  ///< for each offset vector, 1 if its inner vertex is the skin vertex
};

}  // namespace taxel
