// Cutting a triangle to the inside of a tetrahedron, and a tetrahedron by a plane.
#pragma once

#include <array>
#include <span>

#include "core/hydro/pressure_field.h"

namespace taxel {

using Triangle = std::array<dvec3, 3>;

/// A convex polygon of up to 13 vertices (3 of a triangle; each of 4 planes adds one, or half as many again where
/// rounding makes the polygon not quite convex).
struct ClippedPolygon {
  static constexpr std::size_t kCapacity = 16;
  std::array<dvec3, kCapacity> points;
  std::size_t count = 0;
  unsigned cut_by = 0;  ///< bit i: the tet's face i cut the polygon
  [[nodiscard]] std::span<const dvec3> span() const { return {points.data(), count}; }
};

/// The part of `triangle` inside tet number `index`, in the triangle's order; count 0 when there is none.
/// Sutherland-Hodgman in the triangle's barycentric coordinates: each plane is the linear function of its distances at
/// the three corners. Two tets that share a plane see these distances exactly negated, hence the same line, however
/// small the angle. A triangle exactly in a shared plane belongs to the tet of the lower number (half-open faces); in
/// a boundary plane it is inside.
void clip_triangle(const Triangle& triangle, const Tet& tet, int index, ClippedPolygon& out);

/// Corners of the cut of a tet by a plane, from the signed distances of its corners, counter-clockwise about the
/// direction of growing distance; count 0, 3 or 4. A corner at distance 0 counts as positive, so a face in the plane
/// belongs to the tet on its negative side alone. Points on an edge are computed from its lower vertex number:
/// neighbours get the same bits.
void slice_tet(const std::array<dvec3, 4>& corners, const ivec4& vertices, const std::array<double, 4>& distances,
               ClippedPolygon& out);

/// The part of `triangle` where the distances are not positive, in its order.
void clip_triangle_by_plane(const Triangle& triangle, const dvec3& distances, ClippedPolygon& out);

}  // namespace taxel
