// A pressure field in the form that the contact kernel reads: packed planes, a tree over the tets, a grid of distances.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/kernel/index/distance_grid.h"
#include "core/hydro/kernel/index/wide_tree.h"
#include "core/hydro/kernel/surface_writer.h"

namespace taxel {

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
