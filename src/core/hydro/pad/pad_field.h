// The parts of which make_pad_field() makes the field of a pad: one or two layers of prisms between the skin and the
// inner vertices, the pressures at the vertices and their error, caps, and the refinement of the skin.
#pragma once

#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/pad/pad_shape.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// The layers of a pad. If an offset vector has a middle vertex, the prisms around it are divided into an outer prism,
/// from the skin to the middle vertices, and an inner prism, from the middle vertices to the inner vertices. At an
/// offset vector without a middle vertex, the inner prism ends in a point at the inner vertex, so adjacent prisms share
/// their sides whether they have one layer or two. Gaps between faces whose normals diverge are divided in the same
/// way.
class PadLayers {
 public:
  /// Each offset vector whose flag in `asked` is set gets a middle vertex at a fraction of its length. Around it, the
  /// middle vertices descend to the inner vertices at 45 degrees or less, so that prisms are well shaped; offset
  /// vectors whose prisms would not be have no middle vertex. Cost: a closest-point query per middle vertex.
  PadLayers(const PadShape& shape, const MeshIndex& index, const std::vector<char>& asked);

  /// Returns the index of an offset vector's middle vertex, or -1. The indices follow those of the skin and of the
  /// inner vertices.
  [[nodiscard]] int middle(int offset) const { return middle_[at(offset)]; }
  /// Returns the offset vectors of the middle vertices, in the order of their indices.
  [[nodiscard]] const std::vector<int>& offsets() const { return offsets_; }
  /// Returns the distance of the middle vertex along its offset vector [m].
  [[nodiscard]] double height(int offset) const { return height_[at(offset)]; }
  /// Returns the distance of the middle vertex to the skin [m].
  [[nodiscard]] double depth(int offset) const { return depth_[at(offset)]; }
  /// Returns all tets of the pad. Their volumes are positive.
  [[nodiscard]] const std::vector<ivec4>& tets() const { return tets_; }
  /// Returns true if a face has no prism below it.
  [[nodiscard]] bool bare(int face) const { return single_[at(face)].count == 0; }
  /// Returns the number of faces whose prism has two layers at one offset vector or more.
  [[nodiscard]] int two_layer_faces() const { return two_layer_faces_; }

 private:
  [[nodiscard]] bool has(int offset) const { return middle_[at(offset)] >= 0; }
  [[nodiscard]] int top(int offset) const { return has(offset) ? middle_[at(offset)] : shape_.inner(offset); }
  [[nodiscard]] std::array<dvec3, 4> corners(const ivec4& tet) const;
  void spread(const std::vector<char>& asked);
  void place(const MeshIndex& index);
  [[nodiscard]] PrismTets below(const ivec3& offsets) const;
  [[nodiscard]] bool add_face(int face);
  [[nodiscard]] bool add_gap(std::vector<ivec4> outer, const std::vector<ivec3>& floor);
  bool cut();
  void number();

  const PadShape& shape_;
  const TriMesh& mesh_;
  std::vector<PrismTets> single_;  ///< for each face, its prism with one layer
  std::vector<double> height_, depth_;
  std::vector<int> middle_;
  std::vector<int> offsets_;
  std::vector<ivec4> tets_;
  int two_layer_faces_ = 0;
};

/// Two measures of the depth of the inner vertices, one value per offset vector [m], at most the thickness. They only
/// differ where the skin is concave: there the distance to the skin exceeds the depth below the planes of the faces
/// around the vertex.
struct PadDepths {
  std::vector<double> below_skin;
  std::vector<double> below_planes;  ///< area-weighted mean over the faces of the offset vector, at most below_skin
  std::vector<double> planes;        ///< unlimited area-weighted mean; the thickness for an offset vector without faces
};

PadDepths pad_depths(const TriMesh& mesh, const PadShape& shape, double thickness);

/// Flags the offset vectors at which the normals of the skin diverge too much for one layer: the two depths differ by
/// more than a tenth of the thickness.
std::vector<char> diverging_offsets(const PadDepths& depths, double thickness);

/// Returns p = E depth/H at all vertices of a pad; 0 on the skin. At middle vertices, and at inner vertices of offset
/// vectors without a middle vertex, the depth is the smaller of the two measures, so that the stiffness at the skin is
/// E/H. At inner vertices of offset vectors with a middle vertex, the depth is the value between the two measures with
/// which the prisms around the offset vector approximate the distance to the skin best. Cost: a closest-point query per
/// face around these offset vectors.
std::vector<double> pad_pressures(const MeshIndex& index, const PadShape& shape, const PadLayers& layers,
                                  const PadDepths& depths, double modulus, double thickness);

/// A face of the skin, given by its tet and the opposite corner.
struct SkinFace {
  int tet, corner;
};

/// Returns all faces of the skin that have a tet, in the order of the tets.
std::vector<SkinFace> skin_faces(const PressureField& field);

/// Finds the pressures [Pa] at the ascending `depths` [m] along the normal below a point x of a skin face, from tet to
/// tet; -1 if no tet is reached.
void pressures_below(const PressureField& field, const SkinFace& face, const dvec3& x, std::span<const double> depths,
                     std::span<double> pressures);

/// Returns the errors of presses of 0.1, 0.25, 0.5 and 1 thickness. 1024 points of the skin, each at random in its own
/// part of the area, are followed straight inward from tet to tet. Where the tets reach the depth d of the press, the
/// pressure p there is divided by E/H times the distance to the skin. Mean and deviation of this ratio are computed at
/// the first two depths only, and without points that are less than d/2 away from the skin there, as near sharp edges.
/// Deterministic. Cost: two closest-point queries per point.
std::vector<FieldReport::PressError> press_errors(const MeshIndex& index, const PressureField& field, double modulus,
                                                  double thickness);

// Caps: additional vertices close to a skin face, with which the stiffness at the face is exactly E/H.

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
int split_by_caps(const MeshIndex& index, PadTets& pad, double modulus, double thickness);

/// Adds a tet to each face without one (`bare`, one flag per face), if it fits between the tets around the face. The
/// height of the tet is r tan(a/2), where r is the radius of the face's incircle and a the smallest angle at its edges
/// to the skin and to other tets. Clears the flags of these faces, and returns their number. Cost: a tree of all tets,
/// if there are such faces.
int add_own_caps(const MeshIndex& index, PadTets& pad, std::vector<char>& bare, double modulus, double thickness);

// Refinement of a pad's skin. On coarse faces next to sharp edges, the stiffness of the pad below a whole face would
// not be uniform.

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
