// Places on the skin: under the pointer, or near a point. All in the frame M of the mesh file.
#pragma once

#include <optional>

#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

struct SurfacePlace {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};  ///< outward normal of the face
  int face = -1;
};

/// Returns where a ray first meets a face that looks towards the ray's origin, or, with `away`, one that looks away.
std::optional<SurfacePlace> place_under(const MeshIndex& skin, const Ray& ray_M, bool away = false);

/// Returns the place nearest to a point.
SurfacePlace place_near(const MeshIndex& skin, const dvec3& p_M);

/// Returns the corner of the place's face that is nearest to the place.
SurfacePlace nearest_corner(const MeshIndex& skin, const SurfacePlace& place);

/// Returns a direction turned by the shortest rotation from `from` to `to`; unit vectors.
dvec3 turned_with(const dvec3& direction, const dvec3& from, const dvec3& to);

/// Returns a direction turned about an axis (unit vector), by the right-hand rule.
dvec3 turned_about(const dvec3& direction, const dvec3& axis, double radians);

/// Returns how far along a line (unit direction) the point nearest to a ray is; 0 if they are parallel.
double along_line(const dvec3& origin, const dvec3& direction, const Ray& ray);

}  // namespace taxel::ui
