// The signed distance that a wrap polygonises.
#pragma once

#include <memory>

#include "core/mesh/query/nearest_in_turn.h"
#include "core/mesh/repair/draft.h"
#include "core/mesh/repair/wrap/face_sides.h"

namespace taxel {

/// The kind of body that a wrap makes of some faces.
enum class WrapKind {
  solid,            ///< the space that the faces wind around
  sheet,            ///< a body of the pad's thickness behind the faces
  two_sided_sheet,  ///< a body of the pad's thickness around faces without a back side
};

/// Signed distance to the surface of the body that some faces are made into, negative inside. Exact within two edges of
/// the faces; farther away only the sign is meaningful. The nearest face gives the side, except where faces cross or
/// end: there and nowhere else the winding number is computed point by point.
class WrapField {
 public:
  /// `faces` of the draft, none of them without area.
  WrapField(const Draft& draft, const std::vector<int>& faces, WrapKind kind, const RepairLimits& limits);
  /// Not to be called by two threads at once: each call begins with the result of the last one.
  [[nodiscard]] double operator()(const dvec3& p) const;
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }  ///< bounds of the body, with two edges around
  [[nodiscard]] const MeshIndex& faces() const { return *index_; }
  /// The number of pairs of faces that cross, or less if there are more than 2000 and than one for eight faces.
  [[nodiscard]] int crossing_count() const { return crossing_count_; }

 private:
  enum class Cell : char { outside, inside, near_faces, uncertain };
  std::vector<char> find_crossings();
  void classify_cells();
  void classify_by_regions();
  void mark_near(int face);
  [[nodiscard]] double solid_distance(const dvec3& p) const;
  [[nodiscard]] double sheet_distance(const dvec3& p) const;
  [[nodiscard]] double rim_distance(const dvec3& p, double most) const;
  [[nodiscard]] dvec3 cell_center(const ivec3& cell) const { return bounds_.lo + width_ * (dvec3(cell) + 0.5); }
  [[nodiscard]] std::size_t cell_index(const ivec3& cell) const {
    return (at(cell.z) * at(counts_.y) + at(cell.y)) * at(counts_.x) + at(cell.x);
  }

  WrapKind kind_;
  double edge_, thickness_;
  int crossing_count_ = 0;
  std::unique_ptr<MeshIndex> index_;
  std::unique_ptr<WindingNumber> winding_;
  std::unique_ptr<FaceSideFinder> sides_;
  std::unique_ptr<NearestInTurn> nearest_;
  std::vector<char> is_rim_;                  ///< 1 for each half-edge without another face
  std::vector<std::pair<dvec3, dvec3>> rim_;  ///< ends of edges with one face [m]
  Bvh rim_tree_;
  Aabb bounds_;
  double width_ = 0;  ///< width of a cell [m]
  ivec3 counts_{0};
  std::vector<Cell> cells_;
};

}  // namespace taxel
