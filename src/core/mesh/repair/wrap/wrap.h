// Wraps: a new surface around faces that no exact step makes into a solid. FaceSideFinder says which faces are inside
// of a body, WrapField is the signed distance that a wrap polygonises, and distances between both surfaces are
// measured.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/query/nearest.h"
#include "core/mesh/query/winding_number.h"
#include "core/mesh/repair/draft.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The sides of a face of a broken surface: which of them are inside of a body.
enum class FaceSides : char {
  skin,          ///< the body is behind the face and ends there
  both_inside,   ///< a wall within the body
  both_outside,  ///< a face that winds around nothing
  unknown        ///< faces cross or end here: the winding number of each point decides
};

/// Finds the sides of faces. Between crossing faces and rims the winding number on a side of the surface is constant if
/// the surface is closed, so one face answers for all that are connected to it; if it has rims, the mean of some faces
/// does. It is computed when the first of these faces is asked for. Not for two threads at once.
class FaceSideFinder {
 public:
  /// `crosses` has a nonzero entry for each face that crosses another one. The mesh and its winding number must outlive
  /// this object. O(n).
  FaceSideFinder(const TriMesh& mesh, std::vector<char> crosses, const WindingNumber& winding);

  [[nodiscard]] FaceSides sides_of(int face);

 private:
  [[nodiscard]] FaceSides sides_of_patch(const std::vector<int>& patch) const;

  const TriMesh& mesh_;
  const WindingNumber& winding_;
  std::vector<int> patch_of_face_;               ///< patch of each face, or -1 if its sides are unknown
  std::vector<std::vector<int>> patches_;        ///< faces of each patch, ascending
  std::vector<std::optional<FaceSides>> sides_;  ///< sides of each patch, if they are known
};

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

/// Appends to `result` a closed surface around the faces of `source`, which has no other points: the level set of
/// WrapField at `limits.edge`, moved onto the faces if these are near, and simplified by `limits.tolerance`. Cavities
/// are filled, and parts smaller than an edge are dropped. The new faces are marked kWrappedFace. The result does not
/// depend on the unit of length. Throws Error that names /mesh/repair/edge if the lattice would be too large.
void wrap_faces(Draft& result, const Draft& source, WrapKind kind, const RepairLimits& limits, Progress* progress);

/// Fills report.distance_max, report.distance_rms and changes.distance after a wrap with this edge [m]: from 20000
/// points spread evenly over the repaired mesh to the loaded faces, and from as many on the loaded faces to the
/// repaired mesh. Points of loaded faces that are farther than an edge and do not see the outside are left out. The
/// distance of a vertex is the largest one of the points on, or nearest to, the faces around it.
void measure_distances(const MeshIndex& loaded, double edge, RepairedMesh& repaired);

}  // namespace taxel
