// A mesh in the middle of a repair: any triangles over shared points, each with the loaded face that it comes from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

inline constexpr int kFilledFace = -1;   ///< comes from no loaded face
inline constexpr int kWrappedFace = -2;  ///< comes from the nearest loaded face, which is found at the end

/// Faces may be flat, open, doubled or wound in any direction: each step of a repair removes one of these faults.
struct Draft {
  std::vector<dvec3> points;  ///< [m]
  std::vector<ivec3> faces;   ///< counter-clockwise seen from outside, once repaired
  std::vector<int> loaded;    ///< loaded face of each face, or one of the constants above

  [[nodiscard]] int face_count() const { return static_cast<int>(faces.size()); }
  [[nodiscard]] int point_count() const { return static_cast<int>(points.size()); }
  [[nodiscard]] const dvec3& corner(int face, int c) const { return points[at(faces[at(face)][c])]; }
  [[nodiscard]] dvec3 center(int face) const { return (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3.0; }
  /// Normal of a face with twice its area as length.
  [[nodiscard]] dvec3 area_normal(int face) const {
    return glm::cross(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0));
  }
  [[nodiscard]] double area(int face) const { return 0.5 * glm::length(area_normal(face)); }
  /// The edges of the present faces.
  [[nodiscard]] EdgeTopology edges() const { return {faces, points.size()}; }
  /// Adds a face that comes from the loaded face `from`.
  void add(const ivec3& face, int from) {
    faces.push_back(face);
    loaded.push_back(from);
  }
  int add_point(const dvec3& point) {
    points.push_back(point);
    return point_count() - 1;
  }
};

/// Lengths of a recipe with their defaults filled in [m].
struct RepairLimits {
  double diagonal = 0;  ///< diagonal of the loaded mesh's bounds
  double join = 0, fill = 0, edge = 0, tolerance = 0;
  double thickness = 0;    ///< thickness of the body that a sheet becomes
  double loaded_area = 0;  ///< area of the loaded mesh [m^2]
};

/// The loaded faces and, if the mesh is not closed without them, its faces without area.
Draft make_draft(const TriMesh& mesh);
/// Removes the faces with a nonzero entry in `removed`. Keeps the order of the others.
void remove_faces(Draft& draft, const std::vector<char>& removed);
/// Drops points that no face uses. Keeps the order of the others.
void drop_unused_points(Draft& draft);
/// Makes points at the same place one, the first of them.
void join_equal_points(Draft& draft);
/// Returns true if the surface of a triangle is so small that rounding alone can have made it: area <= 1e-9 of the
/// longest edge squared.
bool is_flat(const dvec3& a, const dvec3& b, const dvec3& c);
/// The corner of a face at `vertex`.
int corner_at(const ivec3& face, int vertex);

/// A step that found nothing yet.
RepairStep start_step(const char* code);
/// Counts one more place of a step; the first one is kept.
void add_place(RepairStep& step, const dvec3& place);

}  // namespace taxel
