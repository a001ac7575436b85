// Inner vertices of a pad, and the tets between them and the skin.
#pragma once

#include <span>

#include "core/base/index.h"
#include "core/hydro/fields/prism.h"
#include "core/hydro/pad/pad_legs.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Every leg (pad_legs.h) ends at an inner vertex, offset along it by the pad's thickness, or by less if the body is
/// too thin. Vertices of the skin have their numbers in the mesh; inner ones follow: leg + vertex_count().
class PadShape {
 public:
  /// Cost: some closest-point queries per vertex. `coarse`: a shape of the same surface and thickness whose vertices
  /// come first in this mesh, with their numbers; offset vectors of the same direction take their lengths from there.
  PadShape(const MeshIndex& index, double thickness, const PadShape* coarse = nullptr);

  [[nodiscard]] int leg_count() const { return static_cast<int>(legs_.skin.size()); }
  [[nodiscard]] const PadLegs& legs() const { return legs_; }
  [[nodiscard]] int leg(int face, int corner) const { return legs_.of_face[at(face)][corner]; }
  /// The point this far along a leg.
  [[nodiscard]] dvec3 moved(int leg, double h) const { return skin(leg) + h * legs_.inward[at(leg)].direction; }
  [[nodiscard]] dvec3 inner_position(int leg) const { return moved(leg, offset_[at(leg)]); }
  /// Number of the inner vertex; where the leg is pinched, of the skin's own.
  [[nodiscard]] int inner(int leg) const {
    return pinched_[at(leg)] ? legs_.skin[at(leg)] : leg + mesh_.vertex_count();
  }
  [[nodiscard]] bool pinched(int leg) const { return pinched_[at(leg)] != 0; }
  [[nodiscard]] double offset(int leg) const { return offset_[at(leg)]; }
  [[nodiscard]] const PadDirection& direction(int leg) const { return legs_.inward[at(leg)]; }
  /// Distance of the inner vertex to the skin, not negative [m].
  [[nodiscard]] double depth(int leg) const { return depth_[at(leg)]; }
  /// Whether the offset is shorter than the thickness asks for.
  [[nodiscard]] bool limited(int leg) const { return offset_[at(leg)] < 0.999 * own_[at(leg)].full; }
  /// The offset divided by the offset that the thickness asks for, 0 to 1.
  [[nodiscard]] double part_left(int leg) const { return offset_[at(leg)] / own_[at(leg)].full; }
  /// Tets of positive volume below a face, in skin and inner vertex numbers: three; fewer where corners are pinched,
  /// none where the face has no pad.
  [[nodiscard]] PrismTets tets(int face) const;
  /// inner() of every leg.
  [[nodiscard]] std::vector<int> ends() const;

 private:
  /// A face this nearly edge on to the direction of one of its corners folds back however short the offset.
  static constexpr double kEdgeOn = 0.1;
  /// Largest length of a leg, without regard to other legs.
  struct OwnOffset {
    bool known = false;
    char pinched = 0;
    double offset = 0, full = 0;  ///< `full`: the offset without limits [m]
    double depth = 0;             ///< there [m]; negative: unknown
  };
  /// An inner vertex counts as beyond the medial axis, thus as owned by another part of the skin, where its distance to
  /// the skin is less than this part of the depth that the faces around its own vertex promise.
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
  int vertices_of_legs_ = 0;  ///< number of vertices of the mesh that legs_ belongs to
  std::vector<OwnOffset> own_;
  std::vector<double> offset_;              ///< per leg: its length [m]
  std::vector<double> depth_;               ///< per leg; negative where the offset changed since
  std::vector<char> pinched_;               ///< per leg: its inner vertex is the skin's own
  std::vector<int> first_face_, faces_at_;  ///< faces of a leg: faces_at_ from first_face_[leg] to first_face_[leg + 1]
  std::vector<double> steepest_;            ///< at 3 face + c: how much offsets may differ along the edge from corner c
  std::vector<int> shortened_;              ///< legs whose neighbours' offsets are still to be compared
};

}  // namespace taxel
