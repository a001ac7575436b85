// A pressure field in the form that the contact kernel reads: packed planes, a tree over the tets, a grid of distances.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"

namespace taxel {

/// A grid that gives, by one look-up, a lower bound of the distance of a point to the nearest tet, and a tet near the
/// point.
class DistanceGrid {
 public:
  /// Value of Cell::tet for cells without tets inside the skin (mark_core).
  static constexpr std::int32_t kCoreCell = -2;
  struct Cell {
    /// Lower bound of the distance from every point of the cell to the tets [m]. It is 0 in cells with tets, and in
    /// cells inside of the skin without tets, where depth pieces are used (mark_core).
    float distance = 0;
    std::int32_t tet = -1;   ///< a tet that touches the cell (of its middle if any); -1 or kCoreCell if none
    std::int32_t face = -1;  ///< index in faces(): the plane from which the cell is farthest outside, or -1
  };
  /// The plane of a boundary face of a convex field: the whole field is at n . x + offset >= 0, up to rounding.
  struct Face {
    dvec3 n{0};  ///< inward unit normal
    double offset = 0;
    std::int32_t tet = -1, side = -1;            ///< tet, and the index of its face
    std::array<std::int32_t, 3> neighbours{{}};  ///< faces across the three edges
  };

  DistanceGrid() = default;
  explicit DistanceGrid(const PressureField& field);
  /// Finds the cells without tets that are inside the closed skin or are crossed by it, and sets their distance to 0.
  /// Also finds the gaps of the field below the skin.
  void mark_core(const PressureField& field, const TriMesh& skin);

  /// Returns the lower corner of the grid, which covers slightly more than the bounds of the field.
  [[nodiscard]] const dvec3& low() const { return low_; }
  [[nodiscard]] const ivec3& dims() const { return dims_; }
  [[nodiscard]] double cells_per_metre() const { return per_metre_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }  ///< all cells; x is the fastest index
  /// Returns the whole boundary of a convex field; empty for other fields.
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  void set_faces(std::vector<Face> faces);

  /// Returns the cell of a point, or, for a point outside of the grid, the cell of the nearest point of the grid.
  [[nodiscard]] const Cell& cell_of(const dvec3& p) const {
    const dvec3 r = glm::clamp((p - low_) * per_metre_, dvec3(0), dvec3(dims_ - 1));
    return cells_[index(static_cast<int>(r.x), static_cast<int>(r.y), static_cast<int>(r.z))];
  }

  /// Returns true if the skin crosses the cell of a point and the cell may contain a part of the body without tets.
  /// False before mark_core().
  [[nodiscard]] bool may_hold_gap(const dvec3& p) const {
    return !gaps_.empty() && gaps_[static_cast<std::size_t>(&cell_of(p) - cells_.data())] == kGap;
  }
  /// Returns true if this may be so at some point of a box. It is true for a box of very many cells.
  [[nodiscard]] bool may_hold_gap(const Aabb& box) const;

 private:
  static constexpr std::uint8_t kSkin = 1, kNearCore = 2, kGap = kSkin | kNearCore;
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + dims_.x * (y + dims_.y * z));
  }
  void mark(const PressureField& field);
  void spread(const std::vector<char>& marked);
  void mark_gaps(const PressureField& field, const TriMesh& skin);
  void mark_triangle(const std::array<dvec3, 3>& corners, double margin, std::uint8_t bit);

  dvec3 low_{0};
  ivec3 dims_{0};
  double edge_ = 1, per_metre_ = 1;  ///< edge of a cell [m], and its inverse
  std::vector<Cell> cells_;
  std::vector<Face> faces_;
  std::vector<std::uint8_t> gaps_;  ///< bits kSkin, kNearCore of each cell; empty if the field ends with its tets
};

/// One tetrahedron in three cache lines. Lane i of the planes is the face opposite to vertex i.
struct alignas(64) PackedTet {
  std::array<double, 4> nx, ny, nz, offset;  ///< inward unit normals; inside: n . x + offset >= 0
  std::array<double, 3> gradient;            ///< g [Pa/m]
  double constant = 0;                       ///< p(x) = g . x + c [Pa]
  std::array<std::int32_t, 4> neighbour;     ///< tet across each face, -1 at the boundary
  double size = 0;                           ///< longest edge [m]
  std::uint32_t core_faces = 0;              ///< bit i is set if face i is on a pad's rigid core

  [[nodiscard]] LinearPressure pressure() const { return {{gradient[0], gradient[1], gradient[2]}, constant}; }
};

class FieldIndex {
 public:
  /// `skin` is the skin of a field that continues beyond its tets (depth_field.h), otherwise null.
  explicit FieldIndex(PressureFieldPtr field, const TriMesh* skin = nullptr);
  [[nodiscard]] const PressureField& field() const { return *field_; }
  [[nodiscard]] const std::vector<PackedTet>& tets() const { return tets_; }
  [[nodiscard]] const WideBvh& tree() const { return tree_; }  ///< tree over the tets
  /// A face of only one tet, on the skin or on a core.
  struct BoundaryFace {
    std::array<std::int32_t, 3> vertices;
    std::int32_t tet, side;  ///< tet, and the index of its face
    bool skin;               ///< true if the pressure at its vertices is 0
  };
  [[nodiscard]] const std::vector<BoundaryFace>& boundary_faces() const { return boundary_faces_; }
  [[nodiscard]] const WideBvh& boundary_tree() const { return boundary_tree_; }  ///< tree over the boundary faces
  [[nodiscard]] const DistanceGrid& grid() const { return grid_; }
  /// Returns true if a face of the boundary is not skin. The field ends there although its pressure is not 0.
  [[nodiscard]] bool ends_inside() const { return ends_inside_; }
  /// Returns true if the field continues beyond its tets. Depth pieces are then added where the tets end inside the
  /// body.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  /// Returns true if the tets fill a convex body, up to rounding.
  [[nodiscard]] bool convex() const { return convex_; }
  [[nodiscard]] double mean_tet_size() const { return mean_tet_size_; }  ///< mean of the longest edges [m]

  [[nodiscard]] const ivec4& vertices_of(std::int32_t tet) const {
    return field_->tets()[static_cast<std::size_t>(tet)].vertices;
  }
  [[nodiscard]] std::array<dvec3, 4> corners(std::int32_t tet) const {
    const ivec4& v = vertices_of(tet);
    return {vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3])};
  }
  [[nodiscard]] std::array<double, 4> corner_pressures(std::int32_t tet) const {
    const ivec4& v = vertices_of(tet);
    const auto at = [&](int i) { return field_->vertex_pressure()[static_cast<std::size_t>(i)]; };
    return {at(v[0]), at(v[1]), at(v[2]), at(v[3])};
  }

 private:
  void index_boundary();
  [[nodiscard]] bool boundary_is_convex();
  [[nodiscard]] const dvec3& vertex(int i) const { return field_->vertices()[static_cast<std::size_t>(i)]; }

  PressureFieldPtr field_;
  std::vector<PackedTet> tets_;
  WideBvh tree_, boundary_tree_;
  std::vector<BoundaryFace> boundary_faces_;
  DistanceGrid grid_;
  double mean_tet_size_ = 0;
  bool ends_inside_ = false, convex_ = false, goes_on_ = false;
};

using FieldIndexPtr = std::shared_ptr<const FieldIndex>;

}  // namespace taxel
