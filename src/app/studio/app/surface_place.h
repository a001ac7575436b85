// Places on the skin, as tools need them: under the pointer, near a point. All in the frame M of the mesh file.
#pragma once

#include <optional>

#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

struct SurfacePlace {
  dvec3 position{0};
  dvec3 normal{0, 0, 1};  ///< of the face there, outward
  int face = -1;
};

/// Where a ray meets the skin first, on a face that looks towards its origin; `away`: first on one that looks away.
std::optional<SurfacePlace> place_under(const MeshIndex& skin, const Ray& ray_M, bool away = false);

/// The nearest place.
SurfacePlace place_near(const MeshIndex& skin, const dvec3& p_M);

/// The corner of the place's face that is nearest to it.
SurfacePlace nearest_corner(const MeshIndex& skin, const SurfacePlace& place);

/// A direction taken along when `from` turns to `to`, by the shortest rotation; unit vectors.
dvec3 turned_with(const dvec3& direction, const dvec3& from, const dvec3& to);

/// A direction turned about an axis (unit vector), by the right-hand rule.
dvec3 turned_about(const dvec3& direction, const dvec3& axis, double radians);

/// How far along a line (unit direction) its point nearest to a ray lies; 0 where they are parallel.
double along_line(const dvec3& origin, const dvec3& direction, const Ray& ray);

}  // namespace taxel::ui
