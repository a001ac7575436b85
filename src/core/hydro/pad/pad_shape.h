// Inner vertices of a pad, and the tets between them and the skin.
#pragma once

#include <span>

#include "core/base/index.h"
#include "core/hydro/fields/prism.h"
#include "core/hydro/pad/pad_legs.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// The inner vertices of a pad. Each offset vector (leg, pad_legs.h) ends at an inner vertex. Its length is the pad's
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
