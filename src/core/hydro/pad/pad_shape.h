// The shape of a pad: offset vectors ("legs") from the skin into the pad, the inner vertices at their ends, and the
// tets between them and the skin.
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

/// Returns min(depth, most) of a point inside the mesh. Fast, since only skin within the distance `most` is tested.
double depth_inside(const MeshIndex& index, const dvec3& x, double most);

/// Returns true if, within three percent, `distance` [m] is the distance of a point inside the mesh to the nearest
/// skin, so that no other part of the skin is nearer.
bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance);

/// The inner vertices of a pad. Each offset vector (leg, pad_shape.h) ends at an inner vertex. Its length is the pad's
/// thickness, or less if the body is too thin. Vertices of the skin have their indices in the mesh; the inner vertex of
/// a leg has the index leg + vertex_count().
class PadShape {
 public:
  /// `coarse`, if given, is a shape of the same surface and thickness whose vertices come first in this mesh; offset
  /// vectors with the direction of a coarse one have its length. Cost: some closest-point queries per vertex.
  PadShape(const MeshIndex& index, double thickness, const PadShape* coarse = nullptr);

  [[nodiscard]] int leg_count() const { return static_cast<int>(legs_.skin.size()); }
  [[nodiscard]] const PadLegs& legs() const { return legs_; }
  [[nodiscard]] int leg(int face, int corner) const { return legs_.of_face[at(face)][corner]; }
  /// Returns the point at the distance h along a leg.
  [[nodiscard]] dvec3 moved(int leg, double h) const { return skin(leg) + h * legs_.inward[at(leg)].direction; }
  [[nodiscard]] dvec3 inner_position(int leg) const { return moved(leg, offset_[at(leg)]); }
  /// Returns the index of the inner vertex, or of the skin vertex if the leg is collapsed.
  [[nodiscard]] int inner(int leg) const {
    return pinched_[at(leg)] ? legs_.skin[at(leg)] : leg + mesh_.vertex_count();
  }
  [[nodiscard]] bool pinched(int leg) const { return pinched_[at(leg)] != 0; }
  [[nodiscard]] double offset(int leg) const { return offset_[at(leg)]; }
  [[nodiscard]] const PadDirection& direction(int leg) const { return legs_.inward[at(leg)]; }
  /// Returns the distance of the inner vertex to the skin, not negative [m].
  [[nodiscard]] double depth(int leg) const { return depth_[at(leg)]; }
  /// Returns true if the offset is shorter than required by the thickness.
  [[nodiscard]] bool limited(int leg) const { return offset_[at(leg)] < 0.999 * own_[at(leg)].full; }
  /// Returns the offset divided by the offset that the thickness requires, 0 to 1.
  [[nodiscard]] double part_left(int leg) const { return offset_[at(leg)] / own_[at(leg)].full; }
  /// Returns the tets below a face, as indices of skin and inner vertices. There are three; fewer if corners are
  /// collapsed, and none if the face has no prism. All volumes are positive.
  [[nodiscard]] PrismTets tets(int face) const;
  /// Returns inner() of every leg.
  [[nodiscard]] std::vector<int> ends() const;

 private:
  /// Cosine below which a face is almost edge-on to the direction of one of its corners, so that its prism would be
  /// inverted for any offset.
  static constexpr double kEdgeOn = 0.1;
  /// Largest length of a leg, without the limits by other legs.
  struct OwnOffset {
    bool known = false;
    char pinched = 0;
    double offset = 0, full = 0;  ///< `full` is the offset without limits [m]
    double depth = 0;             ///< depth at the end [m]; negative if unknown
  };
  /// An inner vertex is treated as beyond the medial axis, so that it belongs to another part of the skin, if its
  /// distance to the skin is less than this fraction of its depth below the faces around its own vertex.
  static constexpr double kOwnDepth = 0.95;
  [[nodiscard]] const dvec3& skin(int leg) const { return mesh_.vertices()[at(legs_.skin[at(leg)])]; }
  [[nodiscard]] dvec3 position(int vertex) const;
  [[nodiscard]] double own_offset(int leg, double most, double& depth, dvec3& obstacle) const;
  [[nodiscard]] bool can_be_filled(int face) const;
  [[nodiscard]] PrismTets prism(int face) const;
  [[nodiscard]] bool well_shaped(int face, double part) const;
  [[nodiscard]] std::span<const int> faces_around(int leg) const;
  void set_legs(PadLegs legs);
  void fit();
  void reuse_offsets(const PadLegs& last, int last_vertices, const std::vector<OwnOffset>& own);
  [[nodiscard]] OwnOffset find_own_offset(int leg, dvec3& obstacle) const;
  void gather_faces();
  void shorten(int leg, double offset);
  void smooth();
  [[nodiscard]] bool crosses_wall(int face) const;
  void shrink_crossing();
  void shrink_folded();
  [[nodiscard]] bool is_sound_without(int face, unsigned corners);
  [[nodiscard]] unsigned corners_to_pinch(int face);
  void pinch_folded();
  void lower_fans();
  bool find_folded_gaps(std::vector<char>& whole) const;
  void set_depths(const PadShape* coarse);

  const MeshIndex& index_;
  const TriMesh& mesh_;
  double thickness_;
  PadLegs legs_;
  int vertices_of_legs_ = 0;  ///< number of vertices of the mesh of legs_
  std::vector<OwnOffset> own_;
  std::vector<double> offset_;              ///< length of each leg [m]
  std::vector<double> depth_;               ///< depth of each leg; negative if the offset has changed since
  std::vector<char> pinched_;               ///< for each leg, 1 if its inner vertex is the skin vertex
  std::vector<int> first_face_, faces_at_;  ///< faces of a leg: faces_at_ from first_face_[leg] to first_face_[leg + 1]
  std::vector<double> steepest_;  ///< largest difference of offsets along the edge from corner c, at 3 face + c
  std::vector<int> shortened_;    ///< legs whose neighbours' offsets must still be compared
};

}  // namespace taxel
